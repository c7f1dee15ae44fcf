// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ostream>

#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>

#include <linelet/features/multi_scale_types.h>
#include <linelet/support/visibility.h>

// Makes the record a point type of PCL: its fields go into PCD files by these names.
// clang-format off
POINT_CLOUD_REGISTER_POINT_STRUCT(linelet::MultiScaleShape,
  (float, linearity, linearity)(float, planarity, planarity)(float, sphericity, sphericity)
  (float, optimal_radius, optimal_radius)(float, blend, blend)
  (float, linearity_sum, linearity_sum)(float, linearity_max, linearity_max)
  (float, min_sphericity, min_sphericity)
  (float, major_x, major_x)(float, major_y, major_y)(float, major_z, major_z)
  (std::uint32_t, neighbors, neighbors)(std::uint32_t, first_neighbors, first_neighbors)
  (std::int32_t, scale, scale))
// clang-format on

namespace LINELET_PUBLIC linelet {

inline std::ostream&
operator<<(std::ostream& out, const MultiScaleShape& s)
{
  return out << "(linearity " << s.linearity << ", planarity " << s.planarity
             << ", sphericity " << s.sphericity << ", optimal radius "
             << s.optimal_radius << ", major " << s.major_x << ' ' << s.major_y << ' '
             << s.major_z << ", neighbors " << s.neighbors << ')';
}

} // namespace linelet
