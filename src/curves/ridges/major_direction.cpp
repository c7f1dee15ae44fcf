// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "major_direction.h"

namespace linelet {

Point
majorDirection(const Eigen::Matrix3d& matrix, const Point& like)
{
  Eigen::Matrix3d power = matrix;
  for (int k = 0; k < 5; ++k) {
    const double trace = power.trace();
    if (!(trace > 0))
      return like;
    power /= trace;
    power = (power * power).eval();
  }
  // The longest column is the direction unless the two largest eigenvalues agree.
  int longest = 0;
  for (int k = 1; k < 3; ++k)
    if (power(k, k) > power(longest, longest))
      longest = k;
  Point direction = power.col(longest);
  const double norm = direction.norm();
  if (!(norm > 0))
    return like;
  direction /= norm;
  return direction.dot(like) < 0 ? Point(-direction) : direction;
}

} // namespace linelet
