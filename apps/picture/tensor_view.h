// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/io/cloud.h>

#include "cloud_view.h"
#include "pictures.h"

namespace linelet::apps {

/** \brief A picture with what \a draw draws of a cloud, in colors of linear, planar
 * and, where \a spherical, spherical tensors, which its legend names. */
Canvas
tensorView(const io::Cloud& cloud,
           const PictureSettings& settings,
           bool spherical,
           const DrawImage& draw);

} // namespace linelet::apps
