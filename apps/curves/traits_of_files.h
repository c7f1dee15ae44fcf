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

} // namespace linelet::apps
