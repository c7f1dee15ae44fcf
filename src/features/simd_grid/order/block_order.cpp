// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "block_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <hwy/cache_control.h>

#include "key_sort.h"
#include "support/huge_pages.h"
#include "support/parallel_failure.h"

namespace linelet::grid {

namespace {

/** \brief The largest integer up to \a x; std::floor is a call on old processors. */
std::int64_t
floorOf(double x)
{
  const auto whole = static_cast<std::int64_t>(x);
  return whole - (static_cast<double>(whole) > x ? 1 : 0);
}

} // namespace

BlockFrame::BlockFrame(const Point& low, const Point& high, double edge)
    : edge_(edge), inverse_edge_(1 / edge)
{
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    first_[axis] = floorOf(low[a] * inverse_edge_) - 1;
    counts_[axis] = floorOf(high[a] * inverse_edge_) + 2 - first_[axis];
    // Room for the block after the last one, which is also looked up.
    while ((std::int64_t{1} << bits_[axis]) <= counts_[axis])
      ++bits_[axis];
  }
}

bool
BlockFrame::fits(const Point& low, const Point& high, double edge)
{
  const double farthest =
      std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  return (high - low).maxCoeff() / edge < most_blocks - 4 &&
         farthest / edge < farthest_block;
}

bool
BlockFrame::locate(const Point& point, Cell& cell) const
{
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    const double place = point[a] * inverse_edge_;
    if (!(std::abs(place) < 2 * farthest_block))
      return false;
    cell[axis] = floorOf(place) - first_[axis];
    if (cell[axis] < 0 || cell[axis] >= counts_[axis])
      return false;
  }
  return true;
}

BlockFrame::Cell
BlockFrame::cell(std::uint64_t key) const
{
  Cell cell;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    cell[axis] =
        static_cast<std::int64_t>(key & ((std::uint64_t{1} << bits_[axis]) - 1));
    key >>= bits_[axis];
  }
  return cell;
}

Point
BlockFrame::center(const Cell& cell) const
{
  return edge_ * Point(static_cast<double>(first_[0] + cell[0]) + 0.5,
                       static_cast<double>(first_[1] + cell[1]) + 0.5,
                       static_cast<double>(first_[2] + cell[2]) + 0.5);
}

BlockOrder::BlockOrder(const Points& points,
                       const Indices* chosen,
                       const BlockFrame& frame,
                       int threads)
{
  std::vector<std::uint64_t> keys;
  const std::size_t candidates = chosen != nullptr ? chosen->size() : points.size();
  reserveHuge(keys, candidates);
  reserveHuge(index_, candidates);
  BlockFrame::Cell cell;
  for (std::size_t i = 0; i < candidates; ++i) {
    const Index index = chosen != nullptr ? (*chosen)[i] : static_cast<Index>(i);
    if (frame.locate(points[index], cell)) { // false for NaN
      keys.push_back(frame.key(cell));
      index_.push_back(index);
    }
  }
  sortByKey(keys, index_, frame.keyBits(), threads);

  for (std::size_t i = 0; i < keys.size(); ++i)
    if (i == 0 || keys[i] != keys[i - 1]) {
      keys_.push_back(keys[i]);
      begin_.push_back(i);
    }
  begin_.push_back(keys.size());
  std::vector<std::uint64_t>().swap(keys);

  for (std::vector<double>& axis : coordinates_) {
    reserveHuge(axis, index_.size() + padding);
    axis.resize(index_.size() + padding);
  }
  const auto count = static_cast<std::ptrdiff_t>(blocks());
  ParallelFailure failure;
#pragma omp parallel num_threads(threads)
  {
    std::vector<Entry> entries;
#pragma omp for schedule(dynamic, 8)
    for (std::ptrdiff_t b = 0; b < count; ++b)
      failure.guard(
          [&] { sortBlock(static_cast<std::size_t>(b), points, frame, entries); });
  }
  failure.rethrow();
}

void
BlockOrder::select(
    Entry* begin, Entry* middle, Entry* end, std::size_t axis, float low, float high)
{
  // If points are spread about evenly, interpolation soon finds the border between the
  // halves, in passes without unpredictable branches.
  constexpr int passes = 4;
  for (int pass = 0; pass < passes && end - begin > 4; ++pass) {
    const float border = low + (high - low) * static_cast<float>(middle - begin) /
                                   static_cast<float>(end - begin);
    Entry* next = begin;
    for (Entry* entry = begin; entry != end; ++entry) {
      const Entry taken = *entry;
      *entry = *next;
      *next = taken;
      next += taken.place[axis] < border ? 1 : 0;
    }
    if (next == middle)
      return;
    if (next < middle) {
      begin = next;
      low = border;
    }
    else {
      end = next;
      high = border;
    }
  }
  std::nth_element(begin, middle, end, [axis](const Entry& a, const Entry& b) {
    return a.place[axis] != b.place[axis] ? a.place[axis] < b.place[axis] : a < b;
  });
}

void
BlockOrder::cut(Entry* begin, Entry* end)
{
  while (static_cast<std::size_t>(end - begin) > leaf) {
    std::array<float, 3> low = begin->place, high = low;
    for (const Entry* entry = begin + 1; entry != end; ++entry)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], entry->place[axis]);
        high[axis] = std::max(high[axis], entry->place[axis]);
      }
    std::size_t longest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
      if (high[axis] - low[axis] > high[longest] - low[longest])
        longest = axis;
    Entry* middle = begin + half(static_cast<std::size_t>(end - begin));
    select(begin, middle, end, longest, low[longest], high[longest]);
    cut(begin, middle);
    begin = middle;
  }
  std::sort(begin, end);
}

void
BlockOrder::sortBlock(std::size_t block,
                      const Points& points,
                      const BlockFrame& frame,
                      std::vector<Entry>& entries)
{
  const Point center = frame.center(frame.cell(keys_[block]));
  const std::size_t begin = begin_[block], end = begin_[block + 1];
  // Points are scattered in memory: prefetch all before the first is needed.
  for (std::size_t sorted_index = begin; sorted_index < end; ++sorted_index)
    hwy::Prefetch(&points[index_[sorted_index]]);
  entries.clear();
  for (std::size_t sorted_index = begin; sorted_index < end; ++sorted_index) {
    const Point p = points[index_[sorted_index]] - center;
    entries.push_back({{static_cast<float>(p.x()),
                        static_cast<float>(p.y()),
                        static_cast<float>(p.z())},
                       index_[sorted_index]});
  }
  if (!entries.empty())
    cut(entries.data(), entries.data() + entries.size());
  for (std::size_t sorted_index = begin; sorted_index < end; ++sorted_index) {
    index_[sorted_index] = entries[sorted_index - begin].index;
    const Point& p = points[index_[sorted_index]];
    for (std::size_t axis = 0; axis < 3; ++axis)
      coordinates_[axis][sorted_index] = p[static_cast<Eigen::Index>(axis)];
  }
}

std::size_t
BlockOrder::lowerBound(std::uint64_t key, std::size_t hint) const
{
  std::size_t low = 0, high = blocks();
  if (hint < blocks() && keys_[hint] < key) {
    // In doubling steps: near answers need few, in memory that was just read.
    low = hint;
    for (std::size_t step = 1; low + step < high; step *= 2) {
      if (keys_[low + step] >= key) {
        high = low + step;
        break;
      }
      low += step;
    }
  }
  else if (hint < blocks() && (hint == 0 || keys_[hint - 1] < key))
    return hint;
  using Offset = std::vector<std::uint64_t>::difference_type;
  return static_cast<std::size_t>(
      std::lower_bound(keys_.begin() + static_cast<Offset>(low),
                       keys_.begin() + static_cast<Offset>(high),
                       key) -
      keys_.begin());
}

} // namespace linelet::grid
