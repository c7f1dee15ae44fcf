// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "shape_columns.h"

#include "cloud_files.h"

namespace linelet::apps {

void
addColumns(io::Cloud& cloud, const std::vector<MultiScaleShape>& shapes)
{
  using S = MultiScaleShape;
  const auto add = [&](const char* name, auto member, const char* description) {
    addColumn(cloud, shapes, name, member, description);
  };
  add("linearity", &S::linearity, "CL at the optimal scale");
  add("planarity", &S::planarity, "CP at the optimal scale");
  add("sphericity", &S::sphericity, "CS at the optimal scale");
  add("optimal_radius", &S::optimal_radius, "radius of the optimal scale");
  add("blend", &S::blend, "trust in the eigenvector");
  add("linearity_sum", &S::linearity_sum, "area under linearity graph");
  add("linearity_max", &S::linearity_max, "largest CL of all scales");
  add("min_sphericity", &S::min_sphericity, "smallest CS of all scales");
  add("major_x", &S::major_x, "direction, optimal scale");
  add("major_y", &S::major_y, "direction, optimal scale");
  add("major_z", &S::major_z, "direction, optimal scale");
  add("neighbors", &S::neighbors, "points within optimal radius");
  add("first_neighbors", &S::first_neighbors, "neighbors, smallest scale");
  add("scale", &S::scale, "number of the optimal scale");
}

} // namespace linelet::apps
