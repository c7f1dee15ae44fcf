// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>

#include <linelet/powerline/metric_frame.h>
#include <linelet/powerline_output/output_files.h>

namespace linelet::powerline {

namespace {

constexpr double text_height = 0.5; // of labels in a drawing, meters

io::Value
whole(std::size_t value)
{
  return static_cast<std::int64_t>(value);
}

io::Value
whole(int value)
{
  return static_cast<std::int64_t>(value);
}

/** For reading, not for computing; "-" for what is not known. */
std::string
decimals(double value)
{
  if (!std::isfinite(value))
    return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

io::Attributes
wireAttributes(const Wire& wire,
               const Span& span,
               const MetricFrame& frame,
               const OutputOptions& options)
{
  const Point lowest = frame.world(wire.curve.lowest);
  return {{"wire_id", whole(wire.id)},
          {"span_id", whole(wire.span)},
          {"circuit", whole(wire.circuit)},
          {"span_number", whole(span.number)},
          {"wire_number", whole(wire.number)},
          {"conductors", whole(wire.conductors)},
          {"from_pylon", whole(wire.front_support)},
          {"to_pylon", whole(wire.back_support)},
          {"length", wire.length},
          {"span_length", wire.span_length},
          {"sag", wire.sag},
          {"catenary_a", wire.curve.a},
          {"azimuth", wire.curve.azimuth},
          {"swing", wire.curve.swing},
          {"lowest_x", lowest.x()},
          {"lowest_y", lowest.y()},
          {"lowest_z", lowest.z()},
          {"ground_clearance", wire.ground.distance},
          {"vegetation_clearance", wire.vegetation.distance},
          {"below_clearance", whole(belowClearance(wire, options.clearance) ? 1 : 0)},
          {"points", whole(wire.points)},
          {"rms", wire.rms},
          {"largest_gap", wire.largest_gap},
          {"confidence", wire.confidence},
          {"reason", wire.reason},
          {"review", std::string(nameOf(wire.review.verdict))},
          {"review_class", whole(wire.review.point_class)},
          {"review_note", wire.review.note}};
}

io::VectorFeature
wireFeature(const Wire& wire,
            const Span& span,
            const MetricFrame& frame,
            const OutputOptions& options)
{
  io::VectorFeature feature;
  for (const Point& p : polyline(wire))
    feature.vertices.push_back(frame.world(p));
  feature.attributes = wireAttributes(wire, span, frame, options);
  feature.drawing_layer = "wires_circuit_" + std::to_string(wire.circuit) + "_span_" +
                          std::to_string(span.number) + "_wire_" +
                          std::to_string(wire.number);
  feature.label =
      "wire_id " + std::to_string(wire.id) + ", span_id " + std::to_string(wire.span) +
      ", length " + decimals(wire.length) + ", sag " + decimals(wire.sag) +
      ", catenary_a " + decimals(wire.curve.a) + ", ground_clearance " +
      decimals(wire.ground.distance) + ", vegetation_clearance " +
      decimals(wire.vegetation.distance) + ", confidence " + decimals(wire.confidence);
  return feature;
}

const char*
kindOf(const Support& support)
{
  return support.kind == Support::Kind::Pole ? "pole" : "pylon";
}

io::Attributes
supportAttributes(const Support& support, const MetricFrame& frame)
{
  return {{"pylon_id", whole(support.id)},
          {"kind", std::string(kindOf(support))},
          {"height", support.height},
          {"top_z", frame.world(support.top).z()},
          {"points", whole(support.points)},
          {"confidence", support.confidence}};
}

io::VectorFeature
supportFeature(const Support& support, const MetricFrame& frame)
{
  io::VectorFeature feature;
  feature.vertices = {frame.world(support.base)};
  feature.attributes = supportAttributes(support, frame);
  feature.label = std::string(kindOf(support)) + " " + std::to_string(support.id) +
                  ", height " + decimals(support.height);
  return feature;
}

io::Attributes
unexplainedAttributes(const UnexplainedLine& line)
{
  return {{"line_id", whole(line.id)},
          {"length", line.length},
          {"width", line.width},
          {"points", whole(line.points)}};
}

io::VectorFeature
unexplainedFeature(const UnexplainedLine& line, const MetricFrame& frame)
{
  io::VectorFeature feature;
  for (const Point& p : line.course)
    feature.vertices.push_back(frame.world(p));
  feature.attributes = unexplainedAttributes(line);
  feature.drawing_layer = "unexplained";
  feature.label = "unexplained line " + std::to_string(line.id) + ", length " +
                  decimals(line.length);
  return feature;
}

io::Attributes
jumperAttributes(const Jumper& jumper)
{
  return {{"jumper_id", whole(jumper.id)},
          {"kind", std::string("jumper")},
          {"pylon_id", whole(jumper.support)},
          {"from_wire", whole(jumper.from_wire)},
          {"to_wire", whole(jumper.to_wire)},
          {"length", jumper.length},
          {"sag", jumper.sag},
          {"points", whole(jumper.points)},
          {"rms", jumper.rms}};
}

io::VectorFeature
jumperFeature(const Jumper& jumper, const MetricFrame& frame)
{
  io::VectorFeature feature;
  for (const Point& p : jumper.course)
    feature.vertices.push_back(frame.world(p));
  feature.attributes = jumperAttributes(jumper);
  feature.drawing_layer = "jumpers";
  feature.label = "jumper " + std::to_string(jumper.id) + ", wires " +
                  std::to_string(jumper.from_wire) + " and " +
                  std::to_string(jumper.to_wire) + ", length " +
                  decimals(jumper.length);
  return feature;
}

io::Attributes
insulatorAttributes(const InsulatorString& string)
{
  return {{"insulator_id", whole(string.id)},
          {"kind", std::string(nameOf(string.kind))},
          {"pylon_id", whole(string.support)},
          {"wire_id", whole(string.wire)},
          {"jumper_id", whole(string.jumper)},
          {"length", string.length},
          {"points", whole(string.points)}};
}

io::VectorFeature
insulatorFeature(const InsulatorString& string, const MetricFrame& frame)
{
  io::VectorFeature feature;
  feature.vertices = {frame.world(string.structure), frame.world(string.live)};
  feature.attributes = insulatorAttributes(string);
  feature.drawing_layer = "insulators";
  feature.label = "insulator string " + std::to_string(string.id) + " (" +
                  std::string(nameOf(string.kind)) + "), length " +
                  decimals(string.length);
  return feature;
}

} // namespace

bool
belowClearance(const Wire& wire, double limit)
{
  // Unknown clearances are NaN, which is not below anything.
  return wire.ground.distance < limit || wire.vegetation.distance < limit;
}

std::vector<io::VectorLayer>
powerLineLayers(const io::Cloud& cloud,
                const PowerLineNetwork& network,
                const OutputOptions& options)
{
  const MetricFrame frame(cloud);
  io::VectorLayer wires{"wires", io::VectorLayer::Kind::Lines, {}, {}};
  wires.columns = wireAttributes(Wire(), Span(), frame, options);
  for (const Wire& wire : network.wires) {
    const bool known =
        wire.span > 0 && static_cast<std::size_t>(wire.span) <= network.spans.size();
    const Span none;
    const Span& span =
        known ? network.spans[static_cast<std::size_t>(wire.span) - 1] : none;
    wires.features.push_back(wireFeature(wire, span, frame, options));
  }
  io::VectorLayer pylons{"pylons", io::VectorLayer::Kind::Points, {}, {}};
  pylons.columns = supportAttributes(Support(), frame);
  for (const Support& support : network.supports)
    pylons.features.push_back(supportFeature(support, frame));
  io::VectorLayer unexplained{"unexplained", io::VectorLayer::Kind::Lines, {}, {}};
  unexplained.columns = unexplainedAttributes(UnexplainedLine());
  for (const UnexplainedLine& line : network.unexplained)
    unexplained.features.push_back(unexplainedFeature(line, frame));
  io::VectorLayer jumpers{"jumpers", io::VectorLayer::Kind::Lines, {}, {}};
  jumpers.columns = jumperAttributes(Jumper());
  for (const Jumper& jumper : network.jumpers)
    jumpers.features.push_back(jumperFeature(jumper, frame));
  io::VectorLayer insulators{"insulators", io::VectorLayer::Kind::Lines, {}, {}};
  insulators.columns = insulatorAttributes(InsulatorString());
  for (const InsulatorString& string : network.insulators)
    insulators.features.push_back(insulatorFeature(string, frame));
  std::vector<io::VectorLayer> layers = {std::move(wires),
                                         std::move(pylons),
                                         std::move(unexplained),
                                         std::move(jumpers),
                                         std::move(insulators)};
  for (io::VectorLayer& layer : layers)
    layer.text_height = text_height / frame.units().plan;
  return layers;
}

} // namespace linelet::powerline
