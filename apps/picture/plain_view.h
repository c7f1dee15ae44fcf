// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/io/cloud.h>

#include "cloud_view.h"
#include "pictures.h"

namespace linelet::apps {

/** \brief The common part of all pictures of \a cloud: points, curves, and the
 * viewpoint.
 * \throws io::FileError */
CloudView
plainView(const io::Cloud& cloud, const PictureSettings& settings);

} // namespace linelet::apps
