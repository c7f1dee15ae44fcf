// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/curves/refined_settings.h>
#include <linelet/support/progress_monitor.h>

#include "cloud_files.h"

namespace linelet::apps {

/** \brief The traits of the cloud of all files of \a input. They are read once; with
 * more than a million points, traits are those of randomly chosen squares that together
 * hold about that many.
 * \throws io::FileError, Canceled */
CloudTraits
traitsOfFiles(CloudInput& input, unsigned threads, ProgressMonitor* monitor);

/** \brief The same for the cloud that \a input was read into.
 * \param[in] points relative to \a shift; unused ones are not finite */
CloudTraits
traitsOfCloud(CloudInput& input,
              const Points& points,
              const Point& shift,
              unsigned threads);

} // namespace linelet::apps
