// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "profiles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <linelet/powerline/metric_frame.h>

namespace linelet::view {

namespace {

using powerline::PowerLineNetwork;

constexpr double beside = 3, beyond = 4; ///< meters around the wires that are shown

/** \brief Keeps \a most of \a places, evenly. */
void
thin(std::vector<SpanProfile::Place>& places, std::size_t most)
{
  const std::size_t n = places.size();
  if (n <= most)
    return;
  for (std::size_t i = 0; i < most; ++i)
    places[i] = places[i * n / most];
  places.resize(most);
}

struct Nearest {
  double squared = std::numeric_limits<double>::infinity();
  Point tangent = Point::Zero();
};

void
nearer(const Point& query, const Point& a, const Point& b, Nearest& best)
{
  const Point edge = b - a;
  const double squared_length = edge.squaredNorm();
  const double t = squared_length > 0
                       ? std::clamp((query - a).dot(edge) / squared_length, 0.0, 1.0)
                       : 0;
  const double squared = (query - a - t * edge).squaredNorm();
  if (squared < best.squared)
    best = {squared, edge.normalized()};
}

} // namespace

SpanProfile
profileOf(const Scene& scene, const PowerLineNetwork& network, int id, std::size_t most)
{
  SpanProfile profile;
  profile.span = id;
  const powerline::Span& span = network.spans.at(static_cast<std::size_t>(id) - 1);
  const powerline::MetricFrame frame(scene.cloud);
  Point front = Point::Zero(), back = Point::Zero();
  const auto wireOf = [&](int wire) -> const powerline::Wire& {
    return network.wires.at(static_cast<std::size_t>(wire) - 1);
  };
  if (span.wires.empty())
    return profile;
  for (const int wire : span.wires) {
    front += wireOf(wire).front / static_cast<double>(span.wires.size());
    back += wireOf(wire).back / static_cast<double>(span.wires.size());
  }
  Eigen::Vector2d axis = (back - front).head<2>();
  profile.length = axis.norm();
  axis = profile.length > 0 ? Eigen::Vector2d(axis / profile.length)
                            : Eigen::Vector2d(1, 0);
  const auto place = [&](const Point& p) {
    return SpanProfile::Place{(p - front).head<2>().dot(axis),
                              frame.metersAbove(p.z())};
  };
  const auto across = [&](const Point& p) {
    return (p.x() - front.x()) * axis.y() - (p.y() - front.y()) * axis.x();
  };

  double half_width = 0, highest = -std::numeric_limits<double>::infinity();
  for (const int wire : span.wires) {
    const powerline::Wire& w = wireOf(wire);
    SpanProfile::Wire drawn;
    drawn.id = wire;
    drawn.confidence = w.confidence;
    for (const Point& p : powerline::polyline(w)) {
      drawn.curve.push_back(place(p));
      highest = std::max(highest, p.z());
    }
    half_width =
        std::max({half_width, std::abs(across(w.front)), std::abs(across(w.back))});
    for (const powerline::Clearance* found : {&w.ground, &w.vegetation})
      if (found->known())
        profile.clearances.push_back({place(found->wire),
                                      place(found->other),
                                      found->distance,
                                      found == &w.ground,
                                      wire});
    profile.wires.push_back(std::move(drawn));
  }
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    const Point p = frame.meters(scene.points[i]);
    if (!p.allFinite() || std::abs(across(p)) > half_width + beside)
      continue;
    const SpanProfile::Place at = place(p);
    if (at.along < -beyond || at.along > profile.length + beyond ||
        p.z() > highest + 2 * beyond)
      continue;
    const int of = i < network.wire_id.size() ? network.wire_id[i] : 0;
    const auto wire = std::find_if(profile.wires.begin(),
                                   profile.wires.end(),
                                   [&](const auto& w) { return w.id == of; });
    (of > 0 && wire != profile.wires.end() ? wire->points : profile.others)
        .push_back(at);
  }
  thin(profile.others, most);
  for (SpanProfile::Wire& wire : profile.wires)
    thin(wire.points, most / profile.wires.size());
  if (!network.ground.heights.empty())
    for (double s = -beyond; s <= profile.length + beyond; s += 1) {
      const Eigen::Vector2d at = front.head<2>() + s * axis;
      const double z = network.ground.heightAt(at.x(), at.y());
      if (std::isfinite(z))
        profile.ground.push_back({s, frame.metersAbove(z)});
    }
  return profile;
}

std::vector<VertexError>
errorsAlong(const Curve& curve, const CurveNetwork& truth)
{
  std::vector<VertexError> errors;
  const std::size_t n = curve.points.size();
  double along = 0;
  for (std::size_t i = 0; i < n; ++i) {
    Nearest best;
    for (const Curve& one : truth.curves) {
      const std::size_t edges = one.points.size() - (one.closed ? 0 : 1);
      for (std::size_t k = 0; k < edges && !one.points.empty(); ++k)
        nearer(curve.points[i],
               one.points[k],
               one.points[(k + 1) % one.points.size()],
               best);
    }
    along += i > 0 ? (curve.points[i] - curve.points[i - 1]).norm() : 0;
    const Point tangent =
        curve.points[std::min(i + 1, n - 1)] - curve.points[i > 0 ? i - 1 : 0];
    VertexError error;
    error.along = along;
    error.distance = std::sqrt(best.squared);
    const double cosine = std::abs(tangent.normalized().dot(best.tangent));
    error.angle = tangent.norm() > 0 && best.tangent.norm() > 0
                      ? std::acos(std::min(1.0, cosine)) * 57.29577951308232
                      : std::numeric_limits<double>::quiet_NaN();
    errors.push_back(error);
  }
  return errors;
}

} // namespace linelet::view
