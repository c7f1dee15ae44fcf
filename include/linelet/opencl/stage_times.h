// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC opencl {

/** \brief Elapsed time of every stage, seconds. */
struct StageTimes {
  /// Cells and positions on the host, and their transfer to the device
  double upload = 0;
  double grid = 0;     ///< cell keys, sorting and the cell table
  double nearest = 0;  ///< the search for k nearest points
  double tensor = 0;   ///< the tensor kernel
  double analysis = 0; ///< eigen-analysis and records, on the device
  double download = 0; ///< transfer to the host
};

} // namespace opencl
} // namespace linelet
