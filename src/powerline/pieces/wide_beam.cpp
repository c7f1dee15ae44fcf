// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/wide_beam.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>

#include "powerline/pieces/evidence.h"
#include "powerline/pieces/tube_radius.h"

namespace linelet::powerline {

namespace {

using Residuals = std::vector<Eigen::Vector2d>;

Residuals
residualsOf(const Piece& piece, const Points& points)
{
  Residuals all;
  for (const Index i : piece.members)
    all.push_back(piece.model.residual(points[i], piece.model.along(points[i])));
  return all;
}

// Whether \a residuals belong to two wires rather than spread evenly across a beam, by
// the Bayesian information criterion along their longest axis.
bool
areTwoWires(const Residuals& residuals)
{
  const auto n = static_cast<double>(residuals.size());
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& r : residuals)
    mean += r / n;
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Eigen::Vector2d& r : residuals)
    spread += (r - mean) * (r - mean).transpose() / n;
  const Eigen::Vector2d axis =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors().col(1);
  std::vector<double> across;
  for (const Eigen::Vector2d& r : residuals)
    across.push_back(axis.dot(r - mean));
  std::sort(across.begin(), across.end());
  double squares = 0;
  for (const double x : across)
    squares += x * x;
  // The cut into two that minimizes the squares; the residuals sum to 0.
  double within = squares, sum = 0;
  for (std::size_t i = 0; i + 1 < across.size(); ++i) {
    sum += across[i];
    const double left = static_cast<double>(i + 1);
    within = std::min(within, squares - sum * sum * n / (left * (n - left)));
  }
  const double normal = std::sqrt(2 * M_PI * std::exp(1.0));
  const double two = 2 * std::sqrt(std::max(1e-6, within / n)) * normal;
  return n * std::log((across.back() - across.front()) / two) > std::log(n);
}

} // namespace

void
widenToBeam(const Growth& growth, Piece& piece, const PowerLineSettings& settings)
{
  if (piece.thickness > 0 || !piece.model.isWide() ||
      piece.model.length() < settings.min_length)
    return;
  const Points& points = growth.candidates().points;
  Piece wide = piece;
  SpanModel& m = wide.model;
  // Twice: the first time moves from the side that was followed to the middle.
  for (int round = 0; round < 2; ++round) {
    Indices around;
    for (double s = m.begin; s < m.end; s += bin_length)
      growth.look(m, s, std::min(s + bin_length, m.end), widest_tube_seen, &around);
    std::vector<double> distances;
    for (const Index i : around)
      distances.push_back(m.distance(points[i]));
    m.widest = tubeRadius(std::move(distances));
    if (m.widest <= widest_wire || !growth.collect(wide, m.widest))
      return;
  }
  const double far = std::numeric_limits<double>::infinity();
  if (areTwoWires(residualsOf(wide, points)) ||
      weigh(growth, wide, settings).likelihood <=
          weigh(growth, piece, settings).likelihood ||
      !growth.extend(wide, -far, far))
    return;
  piece = std::move(wide);
}

} // namespace linelet::powerline
