// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/powerline_output/power_line_layers.h>

#include <string>
#include <utility>

#include <linelet/powerline/metric_frame.h>
#include <linelet/powerline_output/below_clearance.h>

#include "layer_values.h"

namespace linelet::powerline {

namespace {

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
  return {worldPoints(polyline(wire), frame),
          wireAttributes(wire, span, frame, options),
          "wires_circuit_" + std::to_string(wire.circuit) + "_span_" +
              std::to_string(span.number) + "_wire_" + std::to_string(wire.number),
          "wire_id " + std::to_string(wire.id) + ", span_id " +
              std::to_string(wire.span) + ", length " + decimals(wire.length) +
              ", sag " + decimals(wire.sag) + ", catenary_a " + decimals(wire.curve.a) +
              ", ground_clearance " + decimals(wire.ground.distance) +
              ", vegetation_clearance " + decimals(wire.vegetation.distance) +
              ", confidence " + decimals(wire.confidence)};
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
  return {worldPoints({support.base}, frame),
          supportAttributes(support, frame),
          "",
          std::string(kindOf(support)) + " " + std::to_string(support.id) +
              ", height " + decimals(support.height)};
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
  return {worldPoints(line.course, frame),
          unexplainedAttributes(line),
          "unexplained",
          "unexplained line " + std::to_string(line.id) + ", length " +
              decimals(line.length)};
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
  return {worldPoints(jumper.course, frame),
          jumperAttributes(jumper),
          "jumpers",
          "jumper " + std::to_string(jumper.id) + ", wires " +
              std::to_string(jumper.from_wire) + " and " +
              std::to_string(jumper.to_wire) + ", length " + decimals(jumper.length)};
}

io::Attributes
insulatorAttributes(const InsulatorString& string)
{
  return {{"insulator_id", whole(string.id)},
          {"kind", named(string.kind)},
          {"pylon_id", whole(string.support)},
          {"wire_id", whole(string.wire)},
          {"jumper_id", whole(string.jumper)},
          {"length", string.length},
          {"points", whole(string.points)}};
}

io::VectorFeature
insulatorFeature(const InsulatorString& string, const MetricFrame& frame)
{
  return {worldPoints({string.structure, string.live}, frame),
          insulatorAttributes(string),
          "insulators",
          "insulator string " + std::to_string(string.id) + " (" +
              std::string(nameOf(string.kind)) + "), length " +
              decimals(string.length)};
}

} // namespace

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
  setTextHeight(layers, frame);
  return layers;
}

} // namespace linelet::powerline
