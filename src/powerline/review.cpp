// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/powerline/review.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace linelet::powerline {

namespace {

/// Meters: half the spacing of conductors in a bundle (0.4 m is usual in Europe; CIGRE
/// Technical Brochure 277).
constexpr double same_wire = 0.2;
constexpr std::size_t samples = 33; ///< places along a wire to compare

double
distanceTo(const Points& line, const Point& p)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point edge = line[i] - line[i - 1];
    const double squared = edge.squaredNorm();
    const double t =
        squared > 0 ? std::clamp((p - line[i - 1]).dot(edge) / squared, 0.0, 1.0) : 0;
    least = std::min(least, (p - line[i - 1] - t * edge).squaredNorm());
  }
  return std::sqrt(least);
}

double
lengthOf(const Points& line)
{
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    length += (line[i] - line[i - 1]).norm();
  return length;
}

/** \brief Share of \a wire that runs along \a line. */
double
covered(const Wire& wire, const Points& line)
{
  std::size_t near = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const double part = (static_cast<double>(i) + 0.5) / samples;
    const Point p =
        wire.curve.at(wire.curve.from + part * (wire.curve.to - wire.curve.from));
    near += distanceTo(line, p) < same_wire ? 1 : 0;
  }
  return static_cast<double>(near) / samples;
}

/** \brief New ids by old id; 0 for what is removed. */
std::vector<int>
renumbered(const std::vector<bool>& kept)
{
  std::vector<int> ids(kept.size() + 1, 0);
  int next = 0;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i])
      ids[i + 1] = ++next;
  return ids;
}

template <class T>
void
keepOnly(std::vector<T>& all, const std::vector<bool>& kept)
{
  std::size_t place = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (kept[i]) {
      if (place != i)
        all[place] = std::move(all[i]);
      ++place;
    }
  all.resize(place);
}

int
newId(const std::vector<int>& ids, int old)
{
  return old > 0 && static_cast<std::size_t>(old) < ids.size()
             ? ids[static_cast<std::size_t>(old)]
             : 0;
}

/** \brief Splits lines with missing spans into the runs between these. */
std::vector<Circuit>
runsOf(const std::vector<Circuit>& circuits,
       const std::vector<int>& spans,
       const std::vector<int>& supports)
{
  std::vector<Circuit> runs;
  for (const Circuit& circuit : circuits) {
    Circuit run;
    const auto end = [&] {
      if (!run.spans.empty()) {
        run.id = static_cast<int>(runs.size()) + 1;
        runs.push_back(run);
      }
      run = Circuit();
    };
    for (std::size_t i = 0; i < circuit.spans.size(); ++i) {
      const int span = newId(spans, circuit.spans[i]);
      if (span == 0) {
        end();
        continue;
      }
      if (run.spans.empty())
        run.supports.push_back(newId(supports, circuit.supports.at(i)));
      run.spans.push_back(span);
      run.supports.push_back(newId(supports, circuit.supports.at(i + 1)));
    }
    end();
  }
  return runs;
}

/** \brief Removes the wires that are not \a kept from \a network. */
void
removeWires(PowerLineNetwork& network, const std::vector<bool>& kept)
{
  const std::vector<int> wires = renumbered(kept);
  std::vector<bool> keep_span, keep_support(network.supports.size(), false);
  for (const Span& span : network.spans)
    keep_span.push_back(std::any_of(span.wires.begin(), span.wires.end(), [&](int id) {
      return newId(wires, id) > 0;
    }));
  for (std::size_t i = 0; i < network.wires.size(); ++i)
    for (const int id : {network.wires[i].front_support, network.wires[i].back_support})
      if (kept[i] && id > 0)
        keep_support[static_cast<std::size_t>(id) - 1] = true;
  for (std::size_t i = 0; i < network.supports.size(); ++i)
    if (network.supports[i].points > 0)
      keep_support[i] = true;
  const std::vector<int> spans = renumbered(keep_span),
                         supports = renumbered(keep_support);

  for (std::size_t i = 0; i < network.wire_id.size(); ++i) {
    const int old = network.wire_id[i], id = newId(wires, old);
    if (old > 0 && id == 0) {
      network.classes[i] = unclassified;
      network.wire_distance[i] = std::numeric_limits<float>::quiet_NaN();
      network.span_id[i] = 0;
    }
    else
      network.span_id[i] = newId(spans, network.span_id[i]);
    network.wire_id[i] = id;
  }
  network.circuits = runsOf(network.circuits, spans, supports);
  keepOnly(network.wires, kept);
  keepOnly(network.spans, keep_span);
  keepOnly(network.supports, keep_support);
  for (std::size_t i = 0; i < network.supports.size(); ++i)
    network.supports[i].id = static_cast<int>(i) + 1;
  for (std::size_t i = 0; i < network.spans.size(); ++i) {
    Span& span = network.spans[i];
    span.id = static_cast<int>(i) + 1;
    span.from_support = newId(supports, span.from_support);
    span.to_support = newId(supports, span.to_support);
    for (int& id : span.wires)
      id = newId(wires, id);
    span.wires.erase(std::remove(span.wires.begin(), span.wires.end(), 0),
                     span.wires.end());
  }
  for (const Circuit& circuit : network.circuits)
    for (std::size_t i = 0; i < circuit.spans.size(); ++i) {
      Span& span = network.spans[static_cast<std::size_t>(circuit.spans[i]) - 1];
      span.circuit = circuit.id;
      span.number = static_cast<int>(i) + 1;
    }
  for (std::size_t i = 0; i < network.wires.size(); ++i) {
    Wire& wire = network.wires[i];
    wire.id = static_cast<int>(i) + 1;
    wire.span = newId(spans, wire.span);
    wire.front_support = newId(supports, wire.front_support);
    wire.back_support = newId(supports, wire.back_support);
    if (wire.span > 0)
      wire.circuit = network.spans[static_cast<std::size_t>(wire.span) - 1].circuit;
  }
  for (Jumper& jumper : network.jumpers) {
    jumper.support = newId(supports, jumper.support);
    jumper.from_wire = newId(wires, jumper.from_wire);
    jumper.to_wire = newId(wires, jumper.to_wire);
  }
  for (InsulatorString& string : network.insulators) {
    string.support = newId(supports, string.support);
    string.wire = newId(wires, string.wire);
  }
}

} // namespace

std::vector<int>
matchReviewed(const PowerLineNetwork& network,
              const std::vector<ReviewedWire>& reviewed)
{
  std::vector<int> matches(network.wires.size(), -1);
  std::vector<double> lengths;
  for (const ReviewedWire& one : reviewed)
    lengths.push_back(lengthOf(one.vertices));
  for (std::size_t w = 0; w < network.wires.size(); ++w) {
    const Wire& wire = network.wires[w];
    double most = 0;
    for (std::size_t r = 0; r < reviewed.size(); ++r) {
      const Points& line = reviewed[r].vertices;
      if (line.size() < 2)
        continue;
      const double share = covered(wire, line), common = share * wire.length;
      if (common > most && common > 0.5 * std::min(wire.length, lengths[r])) {
        most = common;
        matches[w] = static_cast<int>(r);
      }
    }
  }
  return matches;
}

std::vector<std::string>
applyReview(PowerLineNetwork& network, const std::vector<ReviewedWire>& reviewed)
{
  if (reviewed.empty())
    return {};
  const std::vector<int> matches = matchReviewed(network, reviewed);
  std::vector<bool> kept(network.wires.size(), true), found(reviewed.size(), false);
  for (std::size_t w = 0; w < network.wires.size(); ++w) {
    if (matches[w] < 0)
      continue;
    const auto place = static_cast<std::size_t>(matches[w]);
    found[place] = true;
    Wire& wire = network.wires[w];
    wire.review = reviewed[place].review;
    kept[w] = wire.review.verdict != Review::Verdict::Rejected;
    if (wire.review.verdict == Review::Verdict::Accepted) {
      wire.confidence = 1;
      wire.reason.clear();
    }
  }
  removeWires(network, kept);
  std::vector<std::string> sentences;
  for (std::size_t r = 0; r < reviewed.size(); ++r)
    if (!found[r] && reviewed[r].review.verdict == Review::Verdict::Accepted)
      sentences.push_back("wire " + std::to_string(r + 1) +
                          " of the review was accepted, but was not found this time");
  return sentences;
}

} // namespace linelet::powerline
