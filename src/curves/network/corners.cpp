// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "corners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "line_meeting.h"

namespace linelet {

namespace {

constexpr std::size_t window = 4; // nodes within the size of a bend
constexpr std::size_t arm = 3 * window;
constexpr double least_turn = 40 * M_PI / 180;
constexpr double farthest = 4; // sizes from the end of an arm to its corner

/** \brief A bend of a curve, at one of its nodes. */
struct Bend {
  std::size_t node;
  double turn;
  Point corner;
};

/** \brief The bends of \a curve, the sharpest first. */
std::vector<Bend>
bendsOf(const ModelCurve& curve, double size)
{
  const std::size_t n = curve.nodes.size();
  std::vector<Bend> bends;
  if (n <= 2 * arm)
    return bends;
  for (std::size_t k = 0; k < n; ++k) {
    if (!curve.closed && (k < 2 * window || k + 2 * window >= n))
      continue;
    const auto node = [&](std::size_t at) -> const Point& {
      return curve.nodes[at % n];
    };
    const std::size_t before = curve.closed ? k + n - arm : k - std::min(k, arm);
    const std::size_t after = curve.closed ? k + arm : std::min(k + arm, n - 1);
    const Point& in = node(k + n - window);
    const Point& out = node(k + window);
    const Point to = (in - node(before)).normalized();
    const Point from = (node(after) - out).normalized();
    const double turn = std::acos(std::clamp(to.dot(from), -1.0, 1.0));
    if (turn > least_turn)
      bends.push_back(
          {k,
           turn,
           meetingAhead(in, to, out, -from, farthest * size).value_or(node(k))});
  }
  std::sort(bends.begin(), bends.end(), [](const Bend& a, const Bend& b) {
    return a.turn != b.turn ? a.turn > b.turn : a.node < b.node;
  });
  return bends;
}

/** \brief \a curve with hinges at its bends; unchanged if it does not bend. */
ModelCurve
withHinges(const ModelCurve& curve, double size)
{
  const std::size_t n = curve.nodes.size();
  constexpr auto none = static_cast<std::size_t>(-1);
  const std::vector<Bend> bends = bendsOf(curve, size);
  std::vector<std::size_t> bend_of(n, none); // of each node that it replaces
  for (std::size_t b = 0; b < bends.size(); ++b) {
    const auto near = [&](std::size_t offset) {
      return std::array{(bends[b].node + offset) % n, (bends[b].node + n - offset) % n};
    };
    bool alone = true; // no sharper one within two windows
    for (std::size_t o = 0; o <= 2 * window && alone; ++o)
      for (const std::size_t k : near(o))
        alone = alone && bend_of[k] == none;
    for (std::size_t o = 0; o < window && alone; ++o)
      for (const std::size_t k : near(o))
        bend_of[k] = b;
  }
  ModelCurve result = curve;
  result.nodes.clear();
  for (std::size_t k = 0; k < n; ++k)
    if (bend_of[k] == none)
      result.nodes.push_back(curve.nodes[k]);
    else if (bends[bend_of[k]].node == k) {
      result.hinges.push_back(result.nodes.size());
      result.nodes.push_back(bends[bend_of[k]].corner);
    }
  return result;
}

} // namespace

ModelCurves
sharpened(const ModelCurves& curves, double size)
{
  ModelCurves result;
  bool any = false;
  for (const ModelCurve& curve : curves) {
    ModelCurve smooth = curve;
    smooth.hinges.clear();
    ModelCurve sharp = withHinges(resampled(smooth, size / window), size);
    const bool bends = !sharp.hinges.empty();
    any = any || bends;
    if (bends)
      result.push_back(std::move(sharp));
    else
      result.push_back(curve);
  }
  return any ? result : ModelCurves();
}

} // namespace linelet
