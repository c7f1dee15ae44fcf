// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "doubling.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace linelet {

namespace {

constexpr double least_doubled = 12;

} // namespace

ModelCurves
doubled(const ModelCurves& curves,
        const Points& points,
        const UniformGrid& grid,
        double reach,
        double least_spread)
{
  ModelCurves result;
  bool any = false;
  for (const ModelCurve& curve : curves) {
    // Offsets are measured in a frame that is carried along the curve without twist.
    Points firsts, seconds; // axes across each edge
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    double count = 0;
    for (std::size_t e = 0; e < curve.edges(); ++e) {
      const Point chord = curve.to(e) - curve.from(e);
      const double edge_length = chord.norm();
      const Point direction = chord / std::max(edge_length, 1e-300);
      Point first = e == 0 ? direction.unitOrthogonal() : firsts.back();
      first = (first - first.dot(direction) * direction).normalized();
      firsts.push_back(first);
      seconds.push_back(direction.cross(first));
      const Point middle = 0.5 * (curve.from(e) + curve.to(e));
      grid.forEachWithin(middle, reach + edge_length, [&](Index i, double) {
        const Point v = points[i] - middle;
        const Eigen::Vector2d off(v.dot(firsts.back()), v.dot(seconds.back()));
        if (std::abs(v.dot(direction)) > 0.5 * edge_length ||
            off.squaredNorm() > reach * reach)
          return;
        spread += off * off.transpose();
        count += 1;
      });
    }
    // In two dimensions and in frames that turn with the curve, so not a neighborhood
    // tensor.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(spread);
    const Eigen::Vector2d& values = eigen.eigenvalues();
    if (count < least_doubled || values.y() < least_spread * values.x()) {
      result.push_back(curve);
      continue;
    }
    any = true;
    const Eigen::Vector2d shift =
        std::sqrt(values.y() / count) * eigen.eigenvectors().col(1);
    for (const double side : {-1.0, 1.0}) {
      result.push_back(curve);
      Points& nodes = result.back().nodes;
      for (std::size_t k = 0; k < nodes.size(); ++k) {
        const std::size_t e = std::min(k, curve.edges() - 1);
        nodes[k] += side * (shift.x() * firsts[e] + shift.y() * seconds[e]);
      }
    }
  }
  return any ? result : ModelCurves();
}

} // namespace linelet
