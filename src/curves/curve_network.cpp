// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/curve_network.h>

namespace linelet {

double
length(const Curve& curve)
{
  double sum = 0;
  for (std::size_t i = 1; i < curve.points.size(); ++i)
    sum += (curve.points[i] - curve.points[i - 1]).norm();
  if (curve.closed && curve.points.size() > 1)
    sum += (curve.points.front() - curve.points.back()).norm();
  return sum;
}

double
length(const CurveNetwork& network)
{
  double sum = 0;
  for (const Curve& curve : network.curves)
    sum += length(curve);
  return sum;
}

} // namespace linelet
