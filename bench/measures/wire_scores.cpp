// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include <bench/measures/segment_tree.h>
#include <bench/measures/wire_scores.h>

namespace linelet::bench {

namespace {

/** Calls \a visit(point, share) for the midpoints of even pieces of a polyline; share
 * is the length of the piece. */
template <class Visit>
void
sample(const Points& line, double step, Visit&& visit)
{
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point edge = line[i] - line[i - 1];
    const double length = edge.norm();
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / step)));
    for (int k = 0; k < pieces; ++k)
      visit(Point(line[i - 1] + (k + 0.5) / pieces * edge), length / pieces);
  }
}

double
lengthOf(const Points& line)
{
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    sum += (line[i] - line[i - 1]).norm();
  return sum;
}

/** For every true wire the center line of its bundle, or nothing if it is single. */
std::vector<Points>
middleLines(const std::vector<CorridorWire>& truth)
{
  std::map<std::tuple<int, int, int>, std::vector<std::size_t>> bundles;
  for (std::size_t i = 0; i < truth.size(); ++i)
    bundles[{truth[i].line, truth[i].span, truth[i].number}].push_back(i);
  std::vector<Points> middles(truth.size());
  for (const auto& [key, members] : bundles) {
    if (members.size() < 2)
      continue;
    const Points& first = truth[members[0]].points;
    const Points& second = truth[members[1]].points;
    const std::size_t n = std::min(first.size(), second.size());
    Points middle;
    for (std::size_t k = 0; k < n; ++k)
      middle.push_back(0.5 * (first[k] + second[k]));
    for (const std::size_t i : members)
      middles[i] = middle;
  }
  return middles;
}

/** The share of \a line within \a reach of the found curve \a curve. */
double
coveredBy(const SegmentTree& tree,
          std::size_t curve,
          const Points& line,
          const WireScoreSettings& s)
{
  double covered = 0;
  sample(line, 4 * s.step, [&](const Point& p, double share) {
    if (tree.nearestOn(curve, p).squared_distance <= s.whole * s.whole)
      covered += share;
  });
  return covered / lengthOf(line);
}

/** Distance from an attachment to the nearer end of a vector; for a bundle drawn as one
 * vector, from the center of its attachments. */
double
endError(const Curve& curve, const Point& attachment, const Point* middle)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Point& end : {curve.points.front(), curve.points.back()}) {
    least = std::min(least, (end - attachment).norm());
    if (middle != nullptr)
      least = std::min(least, (end - *middle).norm());
  }
  return least;
}

/** Looks for the single vector that represents this wire, and at its ends. */
void
scoreSpan(const SegmentTree& tree,
          const CurveNetwork& found,
          const CorridorWire& wire,
          const Points& middle,
          const WireScoreSettings& s,
          WireScores& scores)
{
  double best = 0;
  std::size_t vector = 0;
  for (std::size_t k = 0; k < found.curves.size(); ++k) {
    if (found.curves[k].points.size() < 2)
      continue;
    double share = coveredBy(tree, k, wire.points, s);
    if (middle.size() > 1)
      share = std::max(share, coveredBy(tree, k, middle, s));
    if (share > best) {
      best = share;
      vector = k;
    }
  }
  if (best < s.share)
    return;
  ++scores.spans_found;
  const Curve& curve = found.curves[vector];
  const bool bundle = middle.size() > 1;
  if (wire.front_attached)
    scores.end_errors.push_back(
        endError(curve, wire.points.front(), bundle ? &middle.front() : nullptr));
  if (wire.back_attached)
    scores.end_errors.push_back(
        endError(curve, wire.points.back(), bundle ? &middle.back() : nullptr));
}

} // namespace

WireScores&
WireScores::operator+=(const WireScores& other)
{
  true_length += other.true_length;
  covered_length += other.covered_length;
  found_length += other.found_length;
  false_length += other.false_length;
  spans += other.spans;
  spans_found += other.spans_found;
  end_errors.insert(end_errors.end(), other.end_errors.begin(), other.end_errors.end());
  std::sort(end_errors.begin(), end_errors.end());
  return *this;
}

WireScores
scoreWires(const CurveNetwork& found,
           const std::vector<CorridorWire>& truth,
           const WireScoreSettings& settings)
{
  WireScores scores;
  const SegmentTree found_tree(found);
  const std::vector<Points> middles = middleLines(truth);
  CurveNetwork true_network;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const CorridorWire& wire = truth[i];
    Curve curve;
    curve.points = wire.points;
    true_network.curves.push_back(std::move(curve));
    const double length = lengthOf(wire.points);
    if (length < settings.shortest)
      continue;
    // A vector on the center line covers its wires like one on the wire itself.
    const bool bundle = middles[i].size() == wire.points.size();
    const double near2 = settings.near * settings.near;
    Points line = wire.points;
    std::size_t hint = SegmentTree::none;
    double covered = 0;
    sample(line, settings.step, [&](const Point& p, double share) {
      const auto nearest = found_tree.nearest(p, hint);
      hint = nearest.segment;
      double distance2 = nearest.squared_distance;
      if (bundle) {
        const Point off = middles[i].front() - line.front();
        distance2 =
            std::min(distance2, found_tree.nearest(p + off, hint).squared_distance);
      }
      if (distance2 <= near2)
        covered += share;
    });
    scores.true_length += length;
    scores.covered_length += covered;
    ++scores.spans;
    scoreSpan(found_tree, found, wire, middles[i], settings, scores);
  }
  const SegmentTree true_tree(true_network);
  for (const Curve& curve : found.curves)
    sample(curve.points, settings.step, [&](const Point& p, double share) {
      scores.found_length += share;
      if (true_tree.nearest(p).squared_distance > settings.astray * settings.astray)
        scores.false_length += share;
    });
  std::sort(scores.end_errors.begin(), scores.end_errors.end());
  return scores;
}

} // namespace linelet::bench
