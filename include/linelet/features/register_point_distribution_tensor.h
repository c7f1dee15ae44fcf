// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <ostream>

#include <pcl/point_types.h>
#include <pcl/register_point_struct.h>

#include <linelet/features/point_types.h>
#include <linelet/support/visibility.h>

// Makes the record a point type of PCL: its fields go into PCD files by these names.
// clang-format off
POINT_CLOUD_REGISTER_POINT_STRUCT(linelet::PointDistributionTensor,
  (float, xx, xx)(float, xy, xy)(float, xz, xz)(float, yy, yy)(float, yz, yz)(float, zz, zz)
  (float, lambda1, lambda1)(float, lambda2, lambda2)(float, lambda3, lambda3)
  (float, major_x, major_x)(float, major_y, major_y)(float, major_z, major_z)
  (float, normal_x, normal_x)(float, normal_y, normal_y)(float, normal_z, normal_z)
  (float, linearity, linearity)(float, planarity, planarity)(float, sphericity, sphericity)
  (std::uint32_t, neighbors, neighbors))
// clang-format on

namespace LINELET_PUBLIC linelet {

inline std::ostream&
operator<<(std::ostream& out, const PointDistributionTensor& t)
{
  return out << "(linearity " << t.linearity << ", planarity " << t.planarity
             << ", sphericity " << t.sphericity << ", major " << t.major_x << ' '
             << t.major_y << ' ' << t.major_z << ", neighbors " << t.neighbors << ')';
}

} // namespace linelet
