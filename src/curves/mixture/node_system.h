// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "banded_system.h"

namespace linelet {

/** \brief The linear system over the nodes of a curve, its solution, and what the
 * points have added to it. It reuses its memory from curve to curve. */
struct NodeSystem {
  BandedSystem matrix;
  Points solution; ///< first the right-hand sides
  std::vector<double> inverse_diagonal, inverse_next, inverse_after_next;
  std::vector<double> data_diagonal, data_next;
};

} // namespace linelet
