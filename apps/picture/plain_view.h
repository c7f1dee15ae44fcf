// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/io/cloud.h>

#include "cloud_view.h"
#include "pictures.h"

namespace linelet::apps {

/** \brief The view of \a cloud that all pictures of it begin with: points, curves, and
 * where it is looked at from. \throws io::FileError */
CloudView
plainView(const io::Cloud& cloud, const PictureSettings& settings);

} // namespace linelet::apps
