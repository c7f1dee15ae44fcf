// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/clustering/clusters.h>

#include "cell_directory.h"
#include "cell_frame.h"

namespace linelet::clustering {

/** \brief Normals of \a representatives by the empty cells among the 5 x 5 x 5 around
 * each: the mean of the directions from its middle to theirs where they lie on one
 * side, else, as for a wall, the axis of their largest second moment, pointing to where
 * there are more. Zero if all cells around hold points.
 * \param[in] is_filled whether a slot of \a directory holds points */
Points
emptyCellNormals(const std::vector<Representative>& representatives,
                 const CellDirectory& directory,
                 const CellFrame& frame,
                 const std::vector<char>& is_filled,
                 int threads);

} // namespace linelet::clustering
