// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include <bench/measures/scene_scores.h>
#include <bench/measures/segment_tree.h>

namespace linelet::bench {

namespace {

/** Calls \a visit(point, share) for the midpoints of even pieces of a curve; share is
 * the length of the piece. */
template <class Visit>
void
sample(const Curve& curve, double step, Visit&& visit)
{
  const std::size_t n = curve.points.size();
  for (std::size_t i = 1; i < n + (curve.closed && n > 2 ? 1 : 0); ++i) {
    const Point &from = curve.points[i - 1], edge = curve.points[i % n] - from;
    const double length = edge.norm();
    const int pieces = std::max(1, static_cast<int>(std::ceil(length / step)));
    for (int k = 0; k < pieces; ++k)
      visit(Point(from + (k + 0.5) / pieces * edge), length / pieces);
  }
}

Curve
curveOf(Points points)
{
  Curve curve;
  curve.points = std::move(points);
  return curve;
}

/** Thick things: whether a place lies within a distance of their surface. One tree per
 * step of thickness, rounded up. */
class ThickThings {
public:
  void
  add(Points axis, double radius)
  {
    networks_[static_cast<int>(std::ceil(radius / grain - 1e-9))].curves.push_back(
        curveOf(std::move(axis)));
  }

  void
  finish()
  {
    for (const auto& [steps, network] : networks_)
      trees_.emplace_back(steps * grain, SegmentTree(network));
  }

  bool
  within(const Point& p, double distance) const
  {
    return std::any_of(trees_.begin(), trees_.end(), [&](const auto& entry) {
      const double reach = entry.first + distance;
      return entry.second.nearest(p).squared_distance <= reach * reach;
    });
  }

private:
  static constexpr double grain = 0.02; // meters of radius

  std::map<int, CurveNetwork> networks_;
  std::vector<std::pair<double, SegmentTree>> trees_;
};

template <class Tolerance>
void
scoreTruth(const CurveNetwork& found,
           const SceneScan& truth,
           const SceneScoreSettings& settings,
           Tolerance&& tolerance,
           SceneScores& scores)
{
  const SegmentTree tree(found);
  for (const SceneWire& wire : truth.wires) {
    const double reach = tolerance(wire);
    std::size_t hint = SegmentTree::none;
    sample(curveOf(wire.points), settings.step, [&](const Point& p, double share) {
      const auto nearest = tree.nearest(p, hint);
      hint = nearest.segment;
      scores.true_length += share;
      if (nearest.squared_distance <= reach * reach)
        scores.covered_length += share;
    });
  }
}

ThickThings
trueWires(const SceneScan& truth)
{
  ThickThings things;
  for (const SceneWire& wire : truth.wires)
    things.add(wire.points, wire.bundle_radius);
  for (const SceneStructure& s : truth.structures)
    if (s.kind == StructureKind::Jumper)
      things.add({s.from, s.to}, s.radius);
  things.finish();
  return things;
}

ThickThings
longThings(const SceneScan& truth)
{
  ThickThings things;
  for (const SceneWire& wire : truth.wires)
    things.add(wire.points, wire.bundle_radius);
  for (const SceneStructure& s : truth.structures)
    things.add({s.from, s.to}, s.radius);
  things.finish();
  return things;
}

/** Adds the length and the correct length of \a curve. */
void
scoreFound(const Curve& curve,
           const ThickThings& right,
           double step,
           double distance,
           SceneScores& scores)
{
  sample(curve, step, [&](const Point& p, double share) {
    scores.found_length += share;
    if (right.within(p, distance))
      scores.right_length += share;
  });
}

} // namespace

double
SceneScores::recall() const
{
  return covered_length / true_length;
}

double
SceneScores::precision() const
{
  return right_length / found_length;
}

SceneScores&
SceneScores::operator+=(const SceneScores& other)
{
  true_length += other.true_length;
  covered_length += other.covered_length;
  found_length += other.found_length;
  right_length += other.right_length;
  return *this;
}

SceneScores
scoreSceneWires(const CurveNetwork& found,
                const SceneScan& truth,
                const SceneScoreSettings& s)
{
  SceneScores scores;
  const auto tolerance = [&](const SceneWire& wire) {
    return std::max({s.near, s.noises * wire.noise, wire.bundle_radius + s.margin});
  };
  scoreTruth(found, truth, s, tolerance, scores);
  const ThickThings right = trueWires(truth);
  for (const Curve& curve : found.curves)
    scoreFound(curve, right, s.step, s.astray, scores);
  return scores;
}

SceneScores
scoreSceneCurves(const CurveNetwork& found,
                 const SceneScan& truth,
                 const SceneScoreSettings& s)
{
  SceneScores scores;
  const auto tolerance = [&](const SceneWire& wire) {
    return std::max(s.near, wire.bundle_radius + s.margin);
  };
  scoreTruth(found, truth, s, tolerance, scores);
  const ThickThings right = longThings(truth);
  for (const Curve& curve : found.curves)
    scoreFound(curve, right, s.step, s.beside, scores);
  return scores;
}

void
calibrate(const CurveNetwork& found,
          const std::vector<double>& confidence,
          const SceneScan& truth,
          std::vector<CalibrationBin>& bins,
          const SceneScoreSettings& s)
{
  if (confidence.size() != found.curves.size())
    throw std::invalid_argument("calibration needs one confidence per wire");
  const ThickThings right = trueWires(truth);
  for (std::size_t i = 0; i < confidence.size(); ++i) {
    SceneScores own;
    scoreFound(found.curves[i], right, s.step, s.astray, own);
    for (CalibrationBin& bin : bins) {
      const bool last = &bin == &bins.back();
      if (confidence[i] < bin.from || (confidence[i] >= bin.to && !last))
        continue;
      ++bin.wires;
      bin.confidence_sum += confidence[i];
      if (own.right_length > 0.5 * own.found_length)
        ++bin.right;
      break;
    }
  }
}

} // namespace linelet::bench
