// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/io/cloud.h>

#include "cloud_view.h"
#include "pictures.h"

namespace linelet::apps {

/** \brief A picture of whatever \a draw draws of a cloud, in the colors of linear,
 * planar and, if \a spherical, spherical tensors, with a legend. */
Canvas
tensorView(const io::Cloud& cloud,
           const PictureSettings& settings,
           bool spherical,
           const DrawImage& draw);

} // namespace linelet::apps
