// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/powerline_output/class_scheme.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace linelet::powerline {

namespace {

/** \brief The class of a point of a wire: \a standard unless a review gives another. */
std::uint8_t
classOf(const PowerLineNetwork& network, std::size_t point, std::uint8_t standard)
{
  const int id = network.wire_id[point];
  if (id < 1 || static_cast<std::size_t>(id) > network.wires.size())
    return standard;
  const int reviewed =
      network.wires[static_cast<std::size_t>(id) - 1].review.point_class;
  return reviewed < 0 ? standard : static_cast<std::uint8_t>(reviewed);
}

} // namespace

void
check(const ClassScheme& scheme)
{
  for (const unsigned number : {scheme.wire, scheme.tower})
    if (number > 255)
      throw std::invalid_argument("class " + std::to_string(number) +
                                  " does not fit into a LAS file, whose classes are 0 "
                                  "to 255");
  if (scheme.wire == scheme.tower)
    throw std::invalid_argument("--wire-class and --tower-class are both " +
                                std::to_string(scheme.wire) +
                                "; choose different classes");
}

std::size_t
classify(io::Cloud& cloud, const PowerLineNetwork& network, const ClassScheme& scheme)
{
  const std::size_t n = cloud.points.size();
  if (network.classes.size() != n || network.wire_id.size() != n ||
      network.span_id.size() != n || network.wire_distance.size() != n)
    throw std::invalid_argument("the power lines were extracted from another cloud: " +
                                std::to_string(network.classes.size()) +
                                " labels for " + std::to_string(n) + " points");
  check(scheme);
  const auto wire = static_cast<std::uint8_t>(scheme.wire),
             tower = static_cast<std::uint8_t>(scheme.tower);
  std::vector<std::uint8_t> classes(n, 0);
  std::size_t unconfirmed = 0;
  const io::Column* given = cloud.find("classification");
  if (given != nullptr)
    std::visit(
        [&](const auto& values) {
          std::transform(values.begin(), values.end(), classes.begin(), [](auto value) {
            return static_cast<std::uint8_t>(static_cast<double>(value));
          });
        },
        given->values);
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint8_t found = network.classes[i];
    if (found == wire_class || found == pylon_class)
      classes[i] = found == wire_class ? classOf(network, i, wire) : tower;
    else if (found == connector_class)
      classes[i] = connector_class;
    else if (given != nullptr && (classes[i] == wire || classes[i] == tower)) {
      ++unconfirmed;
      if (scheme.existing == ExistingClasses::Reset)
        classes[i] = unclassified;
    }
  }
  cloud.set({"classification", std::move(classes), ""});
  cloud.set({"wire_id", network.wire_id, "wire, 0: none"});
  cloud.set({"span_id", network.span_id, "span, 0: none"});
  cloud.set({"wire_distance", network.wire_distance, "to the wire, m"});
  if (network.is_unexplained.size() == n)
    cloud.set({"unexplained", network.is_unexplained, "1: line, but no wire"});
  return unconfirmed;
}

} // namespace linelet::powerline
