// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/curves/refined_reconstruction.h>
#include <linelet/support/progress_monitor.h>

#include "cloud_files.h"

namespace linelet::apps {

/** \brief What the cloud of all files of \a input is like. They are read once, and of
 * more than a million points the traits are those of some squares, chosen at random,
 * that together hold about so many.
 * \throws io::FileError, Canceled */
CloudTraits
traitsOfFiles(CloudInput& input, unsigned threads, ProgressMonitor* monitor);

/** \brief The same, of the cloud that \a input was read as.
 * \param[in] points by \a shift; those that take no part are not finite */
CloudTraits
traitsOfCloud(CloudInput& input,
              const Points& points,
              const Point& shift,
              unsigned threads);

} // namespace linelet::apps
