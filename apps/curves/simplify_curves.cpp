// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "simplify_curves.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace linelet::apps {

namespace {

double
squaredDistance(const Point& p, const Point& a, const Point& b)
{
  const Point along = b - a;
  const double squared = along.squaredNorm();
  const double t =
      squared > 0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (p - a - t * along).squaredNorm();
}

/** \brief Marks the vertices between \a first and \a last that must be kept; both ends
 * are. */
void
keepBetween(const Points& points,
            std::size_t first,
            std::size_t last,
            double tolerance,
            std::vector<bool>& keep)
{
  std::vector<std::pair<std::size_t, std::size_t>> open = {{first, last}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    double farthest = tolerance * tolerance;
    std::size_t place = a;
    for (std::size_t i = a + 1; i < b; ++i) {
      const double squared =
          squaredDistance(points[i], points[a], points[b % points.size()]);
      if (squared > farthest) {
        farthest = squared;
        place = i;
      }
    }
    if (place == a)
      continue;
    keep[place] = true;
    open.emplace_back(a, place);
    open.emplace_back(place, b);
  }
}

/** \brief Removes the vertices of \a curve that are not kept; their points go to the
 * previous vertex. */
void
thin(Curve& curve, const std::vector<bool>& keep)
{
  Curve thinned = curve;
  thinned.points.clear();
  thinned.support.clear();
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    if (keep[i])
      thinned.points.push_back(curve.points[i]);
    if (curve.support.empty())
      continue;
    if (keep[i])
      thinned.support.push_back(curve.support[i]);
    else
      thinned.support.back() += curve.support[i];
  }
  curve = std::move(thinned);
}

/** \brief The vertex of a closed curve farthest from its first. */
std::size_t
oppositeOf(const Points& points)
{
  std::size_t place = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    if ((points[i] - points[0]).squaredNorm() >
        (points[place] - points[0]).squaredNorm())
      place = i;
  return place;
}

} // namespace

SimplifyTolerance::SimplifyTolerance(std::string_view text) : text_(text)
{
  if (text == "auto")
    return;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), length_);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size() ||
      !(length_ >= 0) || !std::isfinite(length_))
    throw std::invalid_argument("'" + text_ +
                                "' is not a tolerance: give a length, 0 or auto");
}

double
SimplifyTolerance::of(const Curve& curve) const
{
  if (length_ >= 0)
    return length_;
  return std::isfinite(curve.noise) ? curve.noise / 10 : 0;
}

CurveNetwork
simplified(CurveNetwork network, const SimplifyTolerance& tolerances)
{
  std::vector<Points> meetings(network.curves.size());
  for (const Junction& junction : network.junctions)
    for (const std::size_t curve : junction.curves)
      meetings[curve].push_back(junction.position);
  for (std::size_t c = 0; c < network.curves.size(); ++c) {
    Curve& curve = network.curves[c];
    const std::size_t count = curve.points.size();
    const double tolerance = tolerances.of(curve);
    if (count < 3 || !(tolerance > 0))
      continue;
    std::vector<bool> keep(count, false);
    keep.front() = true;
    if (curve.closed)
      keep[oppositeOf(curve.points)] = true;
    else
      keep.back() = true;
    for (const Point& place : meetings[c]) {
      const auto nearer = [&](const Point& a, const Point& b) {
        return (a - place).squaredNorm() < (b - place).squaredNorm();
      };
      const auto at =
          std::min_element(curve.points.begin(), curve.points.end(), nearer);
      keep[static_cast<std::size_t>(at - curve.points.begin())] = true;
    }
    std::vector<std::size_t> fixed;
    for (std::size_t i = 0; i < count; ++i)
      if (keep[i])
        fixed.push_back(i);
    if (curve.closed)
      fixed.push_back(count); // the first once more
    for (std::size_t k = 0; k + 1 < fixed.size(); ++k)
      keepBetween(curve.points, fixed[k], fixed[k + 1], tolerance, keep);
    // A closed curve needs more than two vertices.
    if (curve.closed && std::count(keep.begin(), keep.end(), true) < 3)
      continue;
    thin(curve, keep);
  }
  return network;
}

} // namespace linelet::apps
