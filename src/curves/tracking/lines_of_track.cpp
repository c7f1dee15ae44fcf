// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lines_of_track.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <linelet/search/uniform_grid.h>

#include "curve_frames.h"

namespace linelet {

namespace {

using Offset = Eigen::Vector2d;

constexpr double least_share = 0.08; // of the points, for a line of its own
constexpr std::size_t most_lines = 12;
constexpr std::size_t most_offsets = 1500; // looked at, evenly spread
constexpr double offset_reach = 3;         // standard deviations

/** \brief Offsets of \a points from \a curve, of those within \a distance of it. */
std::vector<Offset>
offsetsFrom(const ModelCurve& curve,
            const CurveFrames& frames,
            const Points& points,
            double distance)
{
  std::vector<Offset> result;
  const UniformGrid grid(points, 2 * distance);
  for (std::size_t e = 0; e < curve.edges(); ++e) {
    const Point chord = curve.to(e) - curve.from(e);
    const double edge = chord.norm();
    const Point middle = 0.5 * (curve.from(e) + curve.to(e));
    const double radius = std::sqrt(distance * distance + 0.25 * edge * edge);
    grid.forEachWithin(middle, radius, [&](Index i, double) {
      const Offset off = offsetAcross(curve, frames, e, points[i]);
      if (std::abs((points[i] - middle).dot(chord)) <= 0.5 * edge * edge &&
          off.norm() <= distance)
        result.push_back(off);
    });
  }
  if (result.size() <= most_offsets)
    return result;
  std::vector<Offset> some;
  for (std::size_t k = 0; k < most_offsets; ++k)
    some.push_back(result[k * result.size() / most_offsets]);
  return some;
}

/** \brief Offsets by their x, for counting those nearby. */
class SortedOffsets {
public:
  explicit SortedOffsets(const std::vector<Offset>& offsets) : order_(offsets.size())
  {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return offsets[a].x() < offsets[b].x();
    });
    for (const std::size_t i : order_) {
      x_.push_back(offsets[i].x());
      y_.push_back(offsets[i].y());
    }
  }

  /** \brief Leaves out the offsets that are \a used. */
  void
  leaveOut(const std::vector<char>& used)
  {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < order_.size(); ++k)
      if (used[order_[k]] == 0) {
        order_[kept] = order_[k];
        x_[kept] = x_[k];
        y_[kept++] = y_[k];
      }
    order_.resize(kept);
    x_.resize(kept);
    y_.resize(kept);
  }

  /** \brief The offset that most lie nearer to than \a near, the first of equals, and
   * how many these are, itself among them. */
  std::pair<std::size_t, std::size_t>
  mostCrowded(double near) const
  {
    const double squared_near = near * near;
    std::size_t best = 0, most = 0, low = 0, high = 0;
    for (std::size_t k = 0; k < order_.size(); ++k) {
      while ((x_[k] - x_[low]) * (x_[k] - x_[low]) >= squared_near)
        ++low;
      while (high < order_.size() &&
             (x_[k] - x_[high]) * (x_[k] - x_[high]) < squared_near)
        ++high;
      if (high - low < most)
        continue;
      std::size_t count = 0;
      for (std::size_t j = low; j < high; ++j) {
        const double dx = x_[k] - x_[j], dy = y_[k] - y_[j];
        count += dx * dx + dy * dy < squared_near ? 1 : 0;
      }
      if (count > most || (count == most && order_[k] < best)) {
        best = order_[k];
        most = count;
      }
    }
    return {best, most};
  }

private:
  std::vector<std::size_t> order_; // places in the offsets
  std::vector<double> x_, y_;
};

/** \brief Where \a offsets gather on the scale \a width, the densest first. */
std::vector<Offset>
modesOf(const std::vector<Offset>& offsets, double width)
{
  std::vector<char> used(offsets.size(), 0);
  std::vector<Offset> modes;
  SortedOffsets left(offsets);
  const double near = 1.5 * width;
  while (modes.size() < most_lines) {
    const auto [first, best] = left.mostCrowded(near);
    if (best == 0 ||
        static_cast<double>(best) < least_share * static_cast<double>(offsets.size()))
      break;
    Offset mode = offsets[first];
    for (int round = 0; round < 3; ++round) {
      Offset sum = Offset::Zero();
      double count = 0;
      for (std::size_t j = 0; j < offsets.size(); ++j)
        if (!used[j] && (mode - offsets[j]).squaredNorm() < near * near) {
          sum += offsets[j];
          count += 1;
        }
      if (count > 0)
        mode = sum / count;
    }
    for (std::size_t j = 0; j < offsets.size(); ++j)
      if ((mode - offsets[j]).norm() < 2.5 * width)
        used[j] = 1;
    left.leaveOut(used);
    modes.push_back(mode);
  }
  return modes;
}

} // namespace

std::vector<ParallelLines>
linesAlong(const ModelCurve& curve,
           const Points& points,
           double noise,
           double least_width)
{
  std::vector<ParallelLines> result;
  const CurveFrames frames = framesOf(curve);
  const std::vector<Offset> offsets =
      offsetsFrom(curve, frames, points, offset_reach * noise);
  for (const double share : {0.5, 0.33, 0.2, 0.12}) {
    const double width = share * noise;
    if (width < least_width)
      break;
    const std::vector<Offset> modes = modesOf(offsets, width);
    if (modes.size() < 2)
      continue;
    ParallelLines lines;
    lines.width = width;
    lines.offsets = modes;
    for (const Offset& mode : modes) {
      lines.curves.push_back(curve);
      Points& nodes = lines.curves.back().nodes;
      for (std::size_t k = 0; k < nodes.size(); ++k) {
        const std::size_t e = std::min(k, curve.edges() - 1);
        nodes[k] += mode.x() * frames.first[e] + mode.y() * frames.second[e];
      }
    }
    result.push_back(std::move(lines));
  }
  return result;
}

} // namespace linelet
