// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/powerline_output/hazard_layers.h>

#include <cstdio>
#include <string>
#include <utility>

#include <linelet/powerline/metric_frame.h>

#include "layer_values.h"

namespace linelet::powerline {

namespace {

void
addPlace(io::Attributes& all,
         const std::string& name,
         const Point& p,
         const MetricFrame& frame)
{
  const Point world = frame.world(p);
  all.emplace_back(name + "_x", world.x());
  all.emplace_back(name + "_y", world.y());
  all.emplace_back(name + "_z", world.z());
}

io::Attributes
attributesOf(const Encroachment& one, const Hazards& of, const MetricFrame& frame)
{
  io::Attributes all = {{"hazard_id", whole(one.id)},
                        {"state", of.state},
                        {"kind", named(one.kind)},
                        {"severity", named(one.severity)},
                        {"wire_id", whole(one.wire)},
                        {"span_id", whole(one.span)},
                        {"circuit", whole(one.circuit)},
                        {"other_id", whole(one.other)},
                        {"distance", one.nearest.distance},
                        {"limit", of.limits.of(one.kind).low},
                        {"vertical", one.vertical},
                        {"horizontal", one.horizontal},
                        {"length", one.length},
                        {"points", whole(one.points)},
                        {"area", one.area},
                        {"volume", one.volume}};
  addPlace(all,
           "from",
           one.line.empty() ? Point(one.nearest.wire) : one.line.front(),
           frame);
  addPlace(
      all, "to", one.line.empty() ? Point(one.nearest.wire) : one.line.back(), frame);
  addPlace(all, "wire", one.nearest.wire, frame);
  addPlace(all, "other", one.nearest.other, frame);
  return all;
}

io::Attributes
attributesOf(const Crossing& one, const Hazards& of, const MetricFrame& frame)
{
  io::Attributes all = {{"crossing_id", whole(one.id)},
                        {"state", of.state},
                        {"severity", named(one.severity)},
                        {"upper_wire_id", whole(one.upper)},
                        {"lower_wire_id", whole(one.lower)},
                        {"vertical", one.vertical},
                        {"distance", one.nearest.distance},
                        {"horizontal", one.horizontal},
                        {"limit", of.limits.of(HazardKind::Wire).low},
                        {"angle", one.angle}};
  addPlace(all, "upper", one.upper_at, frame);
  addPlace(all, "lower", one.lower_at, frame);
  addPlace(all, "nearest_upper", one.nearest.wire, frame);
  addPlace(all, "nearest_lower", one.nearest.other, frame);
  return all;
}

io::Attributes
attributesOf(const FallIn& one, const Hazards& of, const MetricFrame& frame)
{
  io::Attributes all = {{"tree_id", whole(one.id)},
                        {"state", of.state},
                        {"severity", named(one.severity)},
                        {"wire_id", whole(one.wire)},
                        {"span_id", whole(one.span)},
                        {"circuit", whole(one.circuit)},
                        {"height", one.height},
                        {"distance", one.distance},
                        {"gap", one.gap}};
  addPlace(all, "top", one.top, frame);
  addPlace(all, "foot", one.foot, frame);
  addPlace(all, "wire", one.at, frame);
  return all;
}

std::string
meters(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.2f m", value);
  return text;
}

/** A feature with the drawing layer of its kind and severity. */
template <class Hazard>
io::VectorFeature
feature(const Hazard& hazard,
        const Hazards& of,
        const MetricFrame& frame,
        const Points& vertices,
        const std::string& kind,
        const std::string& label)
{
  return {worldPoints(vertices, frame),
          attributesOf(hazard, of, frame),
          "hazard_" + kind + "_" + std::string(nameOf(hazard.severity)),
          label};
}

} // namespace

std::vector<io::VectorLayer>
hazardLayers(const io::Cloud& cloud, const std::vector<Hazards>& states)
{
  using Kind = io::VectorLayer::Kind;
  const MetricFrame frame(cloud);
  const Hazards none;
  io::VectorLayer clearances{
      "clearances", Kind::Lines, {}, attributesOf(Encroachment(), none, frame)};
  io::VectorLayer areas{"clearance_areas", Kind::Polygons, {}, clearances.columns};
  io::VectorLayer crossings{
      "crossings", Kind::Lines, {}, attributesOf(Crossing(), none, frame)};
  io::VectorLayer fall_in{
      "fall_in", Kind::Lines, {}, attributesOf(FallIn(), none, frame)};
  for (const Hazards& at : states) {
    for (const Encroachment& one : at.clearances) {
      const std::string kind(nameOf(one.kind));
      const std::string label = "hazard " + std::to_string(one.id) + ", " + kind + " " +
                                meters(one.nearest.distance) + ", " + at.state;
      clearances.features.push_back(feature(one, at, frame, one.line, kind, label));
      areas.features.push_back(
          feature(one, at, frame, one.outline, kind + "_area", ""));
    }
    for (const Crossing& one : at.crossings)
      crossings.features.push_back(feature(one,
                                           at,
                                           frame,
                                           {one.nearest.wire, one.nearest.other},
                                           "crossing",
                                           "crossing " + std::to_string(one.id) + ", " +
                                               meters(one.nearest.distance) + ", " +
                                               at.state));
    for (const FallIn& one : at.fall_in)
      fall_in.features.push_back(feature(one,
                                         at,
                                         frame,
                                         {one.top, one.at},
                                         "fall_in",
                                         "tree " + std::to_string(one.id) +
                                             ", height " + meters(one.height) +
                                             ", gap " + meters(one.gap)));
  }
  std::vector<io::VectorLayer> layers = {std::move(clearances),
                                         std::move(areas),
                                         std::move(crossings),
                                         std::move(fall_in)};
  setTextHeight(layers, frame);
  return layers;
}

} // namespace linelet::powerline
