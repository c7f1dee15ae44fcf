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

/** \brief Keeps \a most of \a places, evenly spread. */
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

} // namespace linelet::view
