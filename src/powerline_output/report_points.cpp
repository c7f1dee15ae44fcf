// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "report_points.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "report_span_frame.h"

namespace linelet::powerline::report {

namespace {

constexpr double beside = 3, beyond = 4; ///< meters around the wires of a span
constexpr double terrain = 0.4;    ///< meters above ground: what counts as terrain
constexpr std::size_t most = 4000; ///< points drawn per span

/** The spans that touch each cell of the plan, so that few are checked per point. */
class SpanCells {
public:
  SpanCells(const std::vector<SpanFrame>& frames, const Content& content)
  {
    for (const Span& span : content.network.spans)
      for (const int id : span.wires)
        for (const Point& end : {content.wire(id).front, content.wire(id).back}) {
          low_ = low_.cwiseMin(end.head<2>() - Eigen::Vector2d::Constant(cell));
          high_ = high_.cwiseMax(end.head<2>() + Eigen::Vector2d::Constant(cell));
        }
    if (low_.x() > high_.x())
      return;
    columns_ = static_cast<std::size_t>((high_.x() - low_.x()) / cell) + 1;
    const auto rows = static_cast<std::size_t>((high_.y() - low_.y()) / cell) + 1;
    cells_.resize(columns_ * rows);
    for (std::size_t k = 0; k < frames.size(); ++k)
      add(frames[k], static_cast<std::uint32_t>(k));
    for (auto& spans : cells_) {
      std::sort(spans.begin(), spans.end());
      spans.erase(std::unique(spans.begin(), spans.end()), spans.end());
    }
  }

  /** Indices in the list of spans, ascending. */
  const std::vector<std::uint32_t>&
  near(const Point& p) const
  {
    static const std::vector<std::uint32_t> none;
    return covers(p) ? cells_[cellOf(p)] : none;
  }

private:
  static constexpr double cell = 25; // meters

  bool
  covers(const Point& p) const
  {
    return p.x() >= low_.x() && p.y() >= low_.y() && p.x() <= high_.x() &&
           p.y() <= high_.y();
  }

  std::size_t
  cellOf(const Point& p) const
  {
    return static_cast<std::size_t>((p.y() - low_.y()) / cell) * columns_ +
           static_cast<std::size_t>((p.x() - low_.x()) / cell);
  }

  // Steps of half a cell along and across the span miss no cell.
  void
  add(const SpanFrame& frame, std::uint32_t k)
  {
    const double reach = frame.half_width + beside + cell;
    for (double s = -cell; s <= frame.length + cell; s += 0.5 * cell) {
      const Point on_axis = frame.at(s), ahead = frame.at(s + 1);
      const Point left(on_axis.y() - ahead.y(), ahead.x() - on_axis.x(), 0);
      for (double t = -reach; t <= reach; t += 0.5 * cell)
        if (const Point p = on_axis + t * left; covers(p))
          cells_[cellOf(p)].push_back(k);
    }
  }

  Eigen::Vector2d low_ = Eigen::Vector2d::Constant(1e300);
  Eigen::Vector2d high_ = Eigen::Vector2d::Constant(-1e300);
  std::size_t columns_ = 0;
  std::vector<std::vector<std::uint32_t>> cells_;
};

bool
isBeside(const SpanFrame& frame, const Point& p)
{
  const double s = frame.along(p);
  return s > -beyond && s < frame.length + beyond &&
         std::abs(frame.across(p)) < frame.half_width + beside;
}

/** Appends \a points, evenly thinned to \a count. */
void
thin(const Indices& points, std::size_t count, Indices& out)
{
  const std::size_t n = points.size(), kept = std::min(n, count);
  for (std::size_t i = 0; i < kept; ++i)
    out.push_back(points[i * n / kept]);
}

// Points of wires lie on the curves, so a few suffice.
Indices
thinned(Indices points, const PowerLineNetwork& network)
{
  const auto wires = std::stable_partition(
      points.begin(), points.end(), [&](Index i) { return network.wire_id[i] == 0; });
  Indices kept;
  thin({points.begin(), wires}, 3 * most / 4, kept);
  thin({wires, points.end()}, most / 4, kept);
  return kept;
}

} // namespace

std::vector<Indices>
pointsOfSpans(const Content& content)
{
  const PowerLineNetwork& network = content.network;
  std::vector<SpanFrame> frames;
  for (const Span& span : network.spans)
    frames.emplace_back(content, span);
  const SpanCells cells(frames, content);

  std::vector<Indices> found(network.spans.size());
  for (std::size_t i = 0; i < content.cloud.points.size(); ++i) {
    const Point p = content.point(i);
    // The terrain is drawn as an area; its points would only clutter.
    if (!p.allFinite() || p.z() - network.ground.heightAt(p.x(), p.y()) <= terrain)
      continue;
    for (const std::uint32_t k : cells.near(p)) {
      // Wires of other spans are drawn in their own profiles.
      const bool elsewhere =
          network.span_id[i] > 0 && network.span_id[i] != network.spans[k].id;
      if (!elsewhere && isBeside(frames[k], p))
        found[k].push_back(static_cast<Index>(i));
    }
  }
  for (Indices& points : found)
    points = thinned(std::move(points), network);
  return found;
}

} // namespace linelet::powerline::report
