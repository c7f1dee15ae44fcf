// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include <linelet/support/points.h>
#include <linelet/support/visibility.h>
#include <linelet/tensor/neighborhood_tensor.h>

namespace LINELET_PUBLIC linelet {

/** \brief Sums over unweighted neighbors, added one by one, for the tensor around their
 * mean. */
struct PointMoments {
  std::size_t count = 0;
  Point first = Point::Zero();
  SymmetricTensor second;

  /** \param[in] v offset from the query point, so that differences of sums keep their
   * digits */
  void
  add(const Point& v)
  {
    ++count;
    first += v;
    second.add(1, v);
  }

  /** \brief As \ref neighborhoodTensor around the mean; NaN without neighbors. */
  SymmetricTensor
  covariance() const
  {
    const auto n = static_cast<double>(count), square = n * n;
    SymmetricTensor tensor;
    tensor.xx = second.xx / n - first.x() * first.x() / square;
    tensor.xy = second.xy / n - first.x() * first.y() / square;
    tensor.xz = second.xz / n - first.x() * first.z() / square;
    tensor.yy = second.yy / n - first.y() * first.y() / square;
    tensor.yz = second.yz / n - first.y() * first.z() / square;
    tensor.zz = second.zz / n - first.z() * first.z() / square;
    return tensor;
  }
};

} // namespace linelet
