// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "report_span_frame.h"

namespace linelet::powerline::report {

namespace {

constexpr double beside = 3, beyond = 4; ///< metres around the wires of a span
constexpr std::size_t most = 4000;       ///< points drawn of a span

/** Appends \a points, evenly thinned to \a count. */
void
thin(const Indices& points, std::size_t count, Indices& out)
{
  const std::size_t n = points.size(), kept = std::min(n, count);
  for (std::size_t i = 0; i < kept; ++i)
    out.push_back(points[i * n / kept]);
}

} // namespace

std::vector<Indices>
pointsOfSpans(const Content& content)
{
  const auto& network = content.network;
  // Cells of the plan know the spans that touch them, so that a point asks few spans.
  constexpr double cell = 25;
  std::vector<SpanFrame> frames;
  Point low = Point::Constant(1e300), high = Point::Constant(-1e300);
  for (const Span& span : network.spans) {
    frames.emplace_back(content, span);
    for (const int id : span.wires)
      for (const Point& end : {content.wire(id).front, content.wire(id).back}) {
        low = low.cwiseMin(end - Point::Constant(cell));
        high = high.cwiseMax(end + Point::Constant(cell));
      }
  }
  std::vector<Indices> found(network.spans.size());
  if (low.x() > high.x())
    return found;
  const auto columns = static_cast<std::size_t>((high.x() - low.x()) / cell) + 1;
  const auto rows = static_cast<std::size_t>((high.y() - low.y()) / cell) + 1;
  std::vector<std::vector<std::uint32_t>> cells(columns * rows);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const SpanFrame& frame = frames[k];
    const double reach = frame.half_width + beside + cell;
    for (double s = -cell; s <= frame.length + cell; s += 0.5 * cell)
      for (double t = -reach; t <= reach; t += 0.5 * cell) {
        const Point a = frame.at(s), b = frame.at(s + 1);
        const Point p = a + t * Point(a.y() - b.y(), b.x() - a.x(), 0);
        if (p.x() < low.x() || p.y() < low.y() || p.x() > high.x() || p.y() > high.y())
          continue;
        auto& list =
            cells[static_cast<std::size_t>((p.y() - low.y()) / cell) * columns +
                  static_cast<std::size_t>((p.x() - low.x()) / cell)];
        if (list.empty() || list.back() != k)
          list.push_back(static_cast<std::uint32_t>(k));
      }
  }
  for (auto& list : cells) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  for (std::size_t i = 0; i < content.cloud.points.size(); ++i) {
    const Point p = content.point(i);
    if (!p.allFinite() || p.x() < low.x() || p.y() < low.y() || p.x() > high.x() ||
        p.y() > high.y())
      continue;
    // The terrain is drawn as an area; its points would only hide the rest.
    if (!(p.z() - network.ground.heightAt(p.x(), p.y()) > 0.4))
      continue;
    const auto& list =
        cells[static_cast<std::size_t>((p.y() - low.y()) / cell) * columns +
              static_cast<std::size_t>((p.x() - low.x()) / cell)];
    for (const std::uint32_t k : list) {
      const SpanFrame& frame = frames[k];
      const double s = frame.along(p);
      // Wires of other spans are drawn there.
      if (network.span_id[i] > 0 && network.span_id[i] != network.spans[k].id)
        continue;
      if (s > -beyond && s < frame.length + beyond &&
          std::abs(frame.across(p)) < frame.half_width + beside)
        found[k].push_back(static_cast<Index>(i));
    }
  }
  for (Indices& points : found) {
    // Those of wires lie on the curves: a few show where they are.
    const auto wires = std::stable_partition(
        points.begin(), points.end(), [&](Index i) { return network.wire_id[i] == 0; });
    Indices kept;
    thin({points.begin(), wires}, 3 * most / 4, kept);
    thin({wires, points.end()}, most / 4, kept);
    points = std::move(kept);
  }
  return found;
}

} // namespace linelet::powerline::report
