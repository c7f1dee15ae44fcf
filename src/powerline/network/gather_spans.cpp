// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/network/gather_spans.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "powerline/line_priors.h"
#include "powerline/pieces/parallel.h"
#include "powerline/pieces/span_model.h"
#include "powerline/spans/wire_groups.h"
#include "powerline/spans/wire_with_ends.h"

namespace linelet::powerline {

namespace {

constexpr double shared_part = 0.6; // of the longer wire

bool
inOneSpan(const WireWithEnds& a, const WireWithEnds& b)
{
  const int a0 = a.ends[0].support, a1 = a.ends[1].support;
  const int b0 = b.ends[0].support, b1 = b.ends[1].support;
  if (a0 >= 0 && a1 >= 0 && b0 >= 0 && b1 >= 0)
    return std::minmax(a0, a1) == std::minmax(b0, b1);
  const Parallel parallel = compare(a.model(), b.model());
  if (parallel.overlap < shared_part * std::max(a.model().length(), b.model().length()))
    return false;
  // Wires on different levels are apart as well, but only the plan counts.
  const SpanModel& m = a.model();
  const double s = (m.begin + m.end) / 2;
  const Point beside = b.model().at(b.model().along(m.at(s)));
  if ((m.at(s) - beside).head<2>().norm() > priors.company_reach)
    return false;
  const bool same = m.direction.dot(b.model().direction) > 0;
  const auto fits = [](int x, int y) { return x < 0 || y < 0 || x == y; };
  return fits(a0, same ? b0 : b1) && fits(a1, same ? b1 : b0);
}

// Adds a wire to a span, in the direction of its first wire.
void
add(WiresOfSpan& span, const std::vector<WireWithEnds>& wires, std::size_t w)
{
  const bool reversed =
      !span.wires.empty() &&
      wires[w].model().direction.dot(wires[span.wires.front()].model().direction) < 0;
  span.wires.push_back(w);
  span.reversed.push_back(reversed);
  for (std::size_t side = 0; side < 2; ++side)
    if (span.support[side] == 0)
      span.support[side] = wires[w].ends[reversed ? 1 - side : side].support + 1;
}

/** An end of a span that meets an end of another: span, side, span, side. */
using Link = std::tuple<std::size_t, int, std::size_t, int>;

// All links between spans with the number of wires that continue across them, most
// first.
std::vector<std::pair<int, Link>>
countLinks(const std::vector<WiresOfSpan>& spans,
           const std::vector<WireWithEnds>& wires)
{
  std::vector<std::size_t> span_of(wires.size());
  std::vector<char> reversed(wires.size());
  for (std::size_t k = 0; k < spans.size(); ++k)
    for (std::size_t i = 0; i < spans[k].wires.size(); ++i) {
      span_of[spans[k].wires[i]] = k;
      reversed[spans[k].wires[i]] = spans[k].reversed[i];
    }
  const auto sideOfSpan = [&](std::size_t w, int side) {
    return reversed[w] != 0 ? 1 - side : side;
  };
  std::map<Link, int> counts;
  for (std::size_t w = 0; w < wires.size(); ++w)
    for (int side = 0; side < 2; ++side) {
      const End& end = wires[w].ends[static_cast<std::size_t>(side)];
      if (end.partner < 0)
        continue;
      const auto other = static_cast<std::size_t>(end.partner);
      if (span_of[w] < span_of[other])
        ++counts[{span_of[w],
                  sideOfSpan(w, side),
                  span_of[other],
                  sideOfSpan(other, end.partner_side)}];
    }
  std::vector<std::pair<int, Link>> sorted;
  for (const auto& [link, count] : counts)
    sorted.emplace_back(count, link);
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return std::tuple(-a.first, a.second) < std::tuple(-b.first, b.second);
  });
  return sorted;
}

// Links every end of a span with the span in which most of its wires continue.
void
linkSpans(std::vector<WiresOfSpan>& spans, const std::vector<WireWithEnds>& wires)
{
  for (const auto& [count, link] : countLinks(spans, wires)) {
    const auto [a, side_a, b, side_b] = link;
    Next& from_a = spans[a].next[static_cast<std::size_t>(side_a)];
    Next& from_b = spans[b].next[static_cast<std::size_t>(side_b)];
    if (from_a.span >= 0 || from_b.span >= 0)
      continue;
    from_a = {static_cast<int>(b), side_b};
    from_b = {static_cast<int>(a), side_a};
  }
}

} // namespace

std::vector<WiresOfSpan>
gatherSpans(const std::vector<WireWithEnds>& wires)
{
  Groups groups(wires.size());
  uniteNeighbors(groups, wires, priors.company_reach, inOneSpan);
  std::vector<WiresOfSpan> spans;
  std::map<std::size_t, std::size_t> place;
  for (std::size_t w = 0; w < wires.size(); ++w) {
    const auto [it, is_new] = place.emplace(groups.root(w), spans.size());
    if (is_new)
      spans.emplace_back();
    add(spans[it->second], wires, w);
  }
  linkSpans(spans, wires);
  return spans;
}

} // namespace linelet::powerline
