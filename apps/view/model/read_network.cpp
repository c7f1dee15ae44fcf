// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scene.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include <nlohmann/json.hpp>

#include <linelet/powerline/metric_frame.h>

namespace linelet::view {

namespace {

using nlohmann::json;
using powerline::Clearance;
using powerline::MetricFrame;
using powerline::PowerLineNetwork;
using powerline::Support;
using powerline::Wire;

/** \brief Reads summary.json, whose coordinates are those of the file, back into meters
 * relative to the cloud's origin. */
class SummaryReader {
public:
  explicit SummaryReader(const io::Cloud& cloud) : shift_(cloud.shift), frame_(cloud) {}

  void
  read(const json& summary, PowerLineNetwork& network) const
  {
    for (const json& one : summary.at("wires"))
      network.wires.push_back(wire(one));
    for (const json& one : summary.at("spans"))
      network.spans.push_back({one.at("span_id"),
                               one.at("circuit"),
                               one.at("span_number"),
                               identity(one.at("from_pylon")),
                               identity(one.at("to_pylon")),
                               one.at("wires").get<std::vector<int>>(),
                               number(one.at("length")),
                               number(one.at("azimuth"))});
    for (const json& one : summary.at("circuits")) {
      powerline::Circuit circuit;
      circuit.id = one.at("circuit");
      for (const json& id : one.at("spans"))
        circuit.spans.push_back(identity(id));
      for (const json& id : one.at("pylons"))
        circuit.supports.push_back(identity(id));
      network.circuits.push_back(std::move(circuit));
    }
    for (const json& one : summary.at("pylons"))
      network.supports.push_back(support(one));
    for (const json& one : summary.at("jumpers"))
      network.jumpers.push_back(jumper(one));
    for (const json& one : summary.at("insulators"))
      network.insulators.push_back(insulator(one));
  }

private:
  static double
  number(const json& value)
  {
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN()
                           : value.get<double>();
  }

  static int
  identity(const json& value)
  {
    return value.is_null() ? 0 : value.get<int>();
  }

  Point
  place(const json& xyz) const
  {
    const Point world(xyz.at(0), xyz.at(1), xyz.at(2));
    return frame_.meters(world - shift_);
  }

  Clearance
  clearance(const json& value) const
  {
    if (value.is_null())
      return {};
    return {number(value.at("distance")), place(value.at("at")), place(value.at("to"))};
  }

  Wire
  wire(const json& one) const
  {
    Wire wire;
    wire.id = one.at("wire_id");
    wire.span = one.at("span_id");
    wire.circuit = one.at("circuit");
    wire.number = one.at("wire_number");
    wire.conductors = one.at("conductors");
    wire.front_support = identity(one.at("from_pylon"));
    wire.back_support = identity(one.at("to_pylon"));
    wire.front = place(one.at("from"));
    wire.back = place(one.at("to"));
    wire.length = number(one.at("length"));
    wire.span_length = number(one.at("span_length"));
    wire.sag = number(one.at("sag"));
    const json& curve = one.at("catenary");
    wire.curve.a = number(curve.at("a"));
    wire.curve.azimuth = number(curve.at("azimuth"));
    wire.curve.swing = number(curve.at("swing"));
    wire.curve.lowest = place(curve.at("lowest"));
    wire.curve.from = wire.curve.along(wire.front);
    wire.curve.to = wire.curve.along(wire.back);
    wire.ground = clearance(one.at("ground_clearance"));
    wire.vegetation = clearance(one.at("vegetation_clearance"));
    wire.points = one.at("points");
    wire.rms = number(one.at("rms"));
    wire.largest_gap = number(one.at("largest_gap"));
    wire.confidence = number(one.at("confidence"));
    wire.reason = one.at("reason");
    if (const auto review = one.find("review");
        review != one.end() && !review->is_null()) {
      wire.review.verdict = fromName<powerline::Review::Verdict>(
          review->at("verdict").get<std::string>());
      if (!review->at("class").is_null())
        wire.review.point_class = review->at("class");
      wire.review.note = review->at("note");
    }
    return wire;
  }

  Support
  support(const json& one) const
  {
    Support support;
    support.id = one.at("pylon_id");
    support.kind =
        one.at("kind") == "pole" ? Support::Kind::Pole : Support::Kind::Pylon;
    support.base = place(one.at("base"));
    support.height = number(one.at("height"));
    support.top = support.base;
    if (std::isfinite(support.height))
      support.top.z() += support.height;
    support.points = one.at("points");
    support.confidence = number(one.at("confidence"));
    return support;
  }

  powerline::Jumper
  jumper(const json& one) const
  {
    powerline::Jumper jumper;
    jumper.id = one.at("jumper_id");
    jumper.support = identity(one.at("pylon_id"));
    jumper.from_wire = identity(one.at("from_wire"));
    jumper.to_wire = identity(one.at("to_wire"));
    for (const json& xyz : one.at("course"))
      jumper.course.push_back(place(xyz));
    jumper.length = number(one.at("length"));
    jumper.sag = number(one.at("sag"));
    jumper.rms = number(one.at("rms"));
    jumper.points = one.at("points");
    return jumper;
  }

  powerline::InsulatorString
  insulator(const json& one) const
  {
    powerline::InsulatorString string;
    string.id = one.at("insulator_id");
    string.kind =
        fromName<powerline::InsulatorString::Kind>(one.at("kind").get<std::string>());
    string.support = identity(one.at("pylon_id"));
    string.wire = identity(one.at("wire_id"));
    string.jumper = identity(one.at("jumper_id"));
    string.structure = place(one.at("structure"));
    string.live = place(one.at("live"));
    string.length = number(one.at("length"));
    string.points = one.at("points");
    return string;
  }

  Point shift_;
  MetricFrame frame_;
};

template <class T>
std::vector<T>
valuesOf(const io::Cloud& cloud, const char* name, T otherwise)
{
  std::vector<T> values(cloud.points.size(), otherwise);
  if (const io::Column* column = cloud.find(name))
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = static_cast<T>(io::valueAt(*column, i));
  return values;
}

} // namespace

PowerLineNetwork
readNetwork(const std::string& folder, const io::Cloud& classified)
{
  const std::string path = (std::filesystem::path(folder) / "summary.json").string();
  PowerLineNetwork network;
  try {
    std::ifstream in(path);
    SummaryReader(classified).read(json::parse(in), network);
  }
  catch (const json::exception&) {
    throw io::FileError(path +
                        ": is incomplete, or from another version of linelet; run "
                        "linelet powerlines again");
  }
  const auto known = [&](int id, std::size_t count) {
    return id >= 1 && static_cast<std::size_t>(id) <= count;
  };
  for (std::size_t i = 0; i < network.wires.size(); ++i)
    if (network.wires[i].id != static_cast<int>(i) + 1 ||
        !known(network.wires[i].span, network.spans.size()))
      throw io::FileError(path + ": its wires are not numbered in order; run linelet "
                                 "powerlines again");
  for (const powerline::Span& span : network.spans)
    for (const int id : span.wires)
      if (!known(id, network.wires.size()))
        throw io::FileError(path + ": a span names wire " + std::to_string(id) +
                            ", which does not exist; run linelet powerlines again");
  network.classes = valuesOf<std::uint8_t>(classified, "classification", 0);
  network.wire_id = valuesOf<std::int32_t>(classified, "wire_id", 0);
  network.span_id = valuesOf<std::int32_t>(classified, "span_id", 0);
  network.wire_distance = valuesOf<float>(
      classified, "wire_distance", std::numeric_limits<float>::quiet_NaN());
  return network;
}

} // namespace linelet::view
