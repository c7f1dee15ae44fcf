// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief One unit vector per pixel, row by row; NaN where there is none. */
struct NormalImage {
  int width = 0, height = 0;
  std::vector<float> x, y, z;
};

} // namespace linelet
