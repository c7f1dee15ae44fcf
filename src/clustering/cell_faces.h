// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/clustering/cluster_settings.h>
#include <linelet/clustering/clusters.h>

#include "cell_directory.h"
#include "cell_frame.h"

namespace linelet::clustering {

/** \brief The faces of cells that hold points, in the order of the representatives.
 * \param[in] clusters with representatives, and with normals if quads use them
 * \param[in] is_filled whether the cell of each slot holds points */
std::vector<Face>
cellFaces(CellFaces kind,
          const Clusters& clusters,
          const CellDirectory& directory,
          const CellFrame& frame,
          const std::vector<char>& is_filled);

} // namespace linelet::clustering
