// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/curve_likeness.h>

#include <algorithm>
#include <cmath>

#include <linelet/curves/ridge_field.h>

namespace linelet {

namespace {

constexpr std::size_t looked_at = 200;
constexpr std::size_t neighbours_looked_at = 2000; // of each, spread over all of them
constexpr double least_linearity = 0.3;

} // namespace

bool
looksLinear(const Points& points, const UniformGrid& grid, double size)
{
  std::vector<double> best;
  const std::size_t stride = points.size() / looked_at;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    double linearity = 0;
    for (const double radius : {2 * size, 4 * size}) {
      Point first = Point::Zero();
      Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
      double count = 0;
      std::size_t near = 0;
      grid.forEachRun(points[i], radius, [&](std::size_t begin, std::size_t end) {
        near += end - begin;
      });
      const std::size_t step = near / neighbours_looked_at + 1;
      std::size_t skipped = 0; // slots of the next run
      grid.forEachRun(points[i], radius, [&](std::size_t begin, std::size_t end) {
        std::size_t slot = begin + skipped;
        for (; slot < end; slot += step) {
          const Point v = grid.slots()[slot] - points[i];
          if (v.squaredNorm() > radius * radius)
            continue;
          first += v;
          second += v * v.transpose();
          count += 1;
        }
        skipped = slot - end;
      });
      first /= count;
      linearity =
          std::max(linearity, linearityOf(second / count - first * first.transpose()));
    }
    best.push_back(linearity);
  }
  const auto middle = best.begin() + static_cast<std::ptrdiff_t>(best.size() / 2);
  std::nth_element(best.begin(), middle, best.end());
  return *middle >= least_linearity;
}

bool
leadsTo(const EmFit& best, const ModelCurves& start, double tolerance)
{
  if (start.size() != best.curves.size())
    return false;
  const auto rings = [](const ModelCurves& curves) {
    return std::count_if(curves.begin(), curves.end(), [](const ModelCurve& curve) {
      return curve.closed;
    });
  };
  if (rings(start) != rings(best.curves) ||
      std::abs(length(start) - length(best.curves)) > 0.1 * length(best.curves))
    return false;
  Points nodes;
  for (const ModelCurve& curve : best.curves)
    for (const Point& node : resampled(curve, 0.5 * tolerance).nodes)
      nodes.push_back(node);
  const UniformGrid grid(nodes, tolerance);
  for (const ModelCurve& curve : start)
    for (const Point& node : curve.nodes)
      if (grid.nearest(node, tolerance) == UniformGrid::none)
        return false;
  return true;
}

} // namespace linelet
