// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/search/uniform_grid.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

namespace linelet {

UniformGrid::UniformGrid(const Points& points, double row_size) : row_size_(row_size)
{
  if (!(row_size > 0) || !std::isfinite(row_size))
    throw std::invalid_argument("UniformGrid: row size " + std::to_string(row_size) +
                                " is not a positive finite number");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i].allFinite())
      indices_.push_back(static_cast<Index>(i));
  row_begin_.assign(1, 0);
  if (indices_.empty())
    return;

  min_ = max_ = points[indices_.front()];
  for (const Index i : indices_) {
    min_ = min_.cwiseMin(points[i]);
    max_ = max_.cwiseMax(points[i]);
  }

  layRows(points);

  sortIntoRows(points);
  points_.reserve(indices_.size());
  for (const Index i : indices_)
    points_.push_back(points[i]);
}

void
UniformGrid::sortIntoRows(const Points& points)
{
  struct Entry {
    double x;
    Index index;
    bool
    operator<(const Entry& other) const
    {
      return x != other.x ? x < other.x : index < other.index;
    }
  };
  const std::size_t count = indices_.size();
  // First sort all points along x into bins of about one point. Those of a row are then
  // in order, up to the order within a bin.
  const double width = max_.x() - min_.x();
  const double per_point = width / static_cast<double>(count);
  const auto bin = [&](double x) {
    const double place = (x - min_.x()) / per_point; // NaN where all have the same x
    return place < static_cast<double>(count) ? static_cast<std::size_t>(place)
                                              : count - 1;
  };
  std::vector<std::size_t> next(count + 1, 0);
  for (const Index i : indices_)
    ++next[bin(points[i].x()) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<Entry> along_x(count);
  for (const Index i : indices_)
    along_x[next[bin(points[i].x())]++] = {points[i].x(), i};

  std::vector<std::size_t> row_of(points.size());
  row_begin_.assign(rows_[0] * rows_[1] + 1, 0);
  for (const Index i : indices_) {
    row_of[i] = row(points[i].z(), 2) * rows_[0] + row(points[i].y(), 1);
    ++row_begin_[row_of[i] + 1];
  }
  std::partial_sum(row_begin_.begin(), row_begin_.end(), row_begin_.begin());
  next.assign(row_begin_.begin(), row_begin_.end() - 1);
  std::vector<Entry> sorted(count);
  for (const Entry& entry : along_x)
    sorted[next[row_of[entry.index]]++] = entry;

  for (std::size_t r = 0; r + 1 < row_begin_.size(); ++r)
    for (std::size_t i = row_begin_[r], end = i; i < row_begin_[r + 1]; i = end) {
      while (end < row_begin_[r + 1] && bin(sorted[end].x) == bin(sorted[i].x))
        ++end;
      std::sort(sorted.data() + i, sorted.data() + end);
    }
  for (std::size_t i = 0; i < count; ++i)
    indices_[i] = sorted[i].index;
}

void
UniformGrid::layRows(const Points& points)
{
  const auto rows = [&](const Point& extent) {
    return (std::floor(extent.y() / row_size_) + 1) *
           (std::floor(extent.z() / row_size_) + 1);
  };
  const double most_rows = 4.0 * static_cast<double>(indices_.size()) + 64;
  row_low_ = min_;
  Point extent = max_ - min_;
  if (rows(extent) > most_rows) {
    // A few outliers must not widen all rows: points beyond belong to the outermost
    // ones.
    constexpr std::size_t sample = 4096;
    const std::size_t step = std::max<std::size_t>(1, indices_.size() / sample);
    for (int axis = 1; axis < 3; ++axis) {
      std::vector<double> values;
      for (std::size_t i = 0; i < indices_.size(); i += step)
        values.push_back(points[indices_[i]][axis]);
      std::sort(values.begin(), values.end());
      const std::size_t tail = values.size() / 50;
      const double low = values[tail], high = values[values.size() - 1 - tail];
      const double margin = (high - low) / 4;
      row_low_[axis] = std::max(min_[axis], low - margin);
      extent[axis] = std::min(max_[axis], high + margin) - row_low_[axis];
    }
  }
  // Widen the rows before the table outgrows the points.
  while (rows(extent) > most_rows)
    row_size_ *= 2;
  for (int axis = 0; axis < 2; ++axis)
    rows_[axis] = static_cast<std::size_t>(extent[axis + 1] / row_size_) + 1;
}

std::array<double, 2>
UniformGrid::rowBounds(std::size_t row, int axis) const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double slack = 1e-3 * row_size_; // for rounding
  const double low = row_low_[axis] + static_cast<double>(row) * row_size_;
  return {row == 0 ? -infinity : low - slack,
          row + 1 == rows_[axis - 1] ? infinity : low + row_size_ + slack};
}

Indices
UniformGrid::within(const Point& query, double radius) const
{
  Indices found;
  forEachWithin(query, radius, [&](Index i, double) { found.push_back(i); });
  return found;
}

std::size_t
UniformGrid::countWithin(const Point& query, double radius) const
{
  std::size_t count = 0;
  forEachSorted(query, radius, [&](std::size_t, double) { ++count; });
  return count;
}

void
UniformGrid::nearestInRow(std::size_t row, const Point& query, Nearest& best) const
{
  const std::size_t begin = row_begin_[row], end = row_begin_[row + 1];
  // The first sorted index that is not left of the query, by branchless bisection.
  std::size_t first = begin;
  for (std::size_t count = end - begin; count > 0;) {
    const std::size_t half = (count + 1) / 2;
    first += points_[first + half - 1].x() < query.x() ? half : 0;
    count -= half;
  }
  const auto look = [&](std::size_t sorted_index) {
    const Point offset = points_[sorted_index] - query;
    if (offset.x() * offset.x() > best.squared)
      return false;
    const double squared = offset.squaredNorm();
    if (squared < best.squared ||
        (squared == best.squared && indices_[sorted_index] < best.index))
      best = {squared, indices_[sorted_index]};
    return true;
  };
  for (std::size_t sorted_index = first; sorted_index < end && look(sorted_index);)
    ++sorted_index;
  for (std::size_t sorted_index = first;
       sorted_index > begin && look(sorted_index - 1);)
    --sorted_index;
}

Index
UniformGrid::nearest(const Point& query, double max_distance) const
{
  if (points_.empty() || !query.allFinite() || !(max_distance >= 0))
    return none;
  // Rows around that of the query, ring by ring, up to the distance of what was found
  // (and a margin for rounding at their borders).
  const double slack =
      1e-6 * row_size_ +
      1e-15 * (query.cwiseAbs() + min_.cwiseAbs() + max_.cwiseAbs()).maxCoeff();
  const auto distance = [&](std::size_t place, int axis) {
    const double low = row_low_[axis] + static_cast<double>(place) * row_size_;
    const double below = place > 0 ? low - query[axis] : 0;
    const double above =
        place + 1 < rows_[axis - 1] ? query[axis] - (low + row_size_) : 0;
    return std::max(std::max(below, above) - slack, 0.0);
  };
  Nearest best{max_distance * max_distance, none};
  const std::size_t y = row(query.y(), 1), z = row(query.z(), 2);
  const std::size_t rings = std::max(rows_[0], rows_[1]);
  for (std::size_t ring = 0; ring < rings; ++ring) {
    const double gap = static_cast<double>(ring) * row_size_ - row_size_ - slack;
    if (gap > 0 && gap * gap > best.squared)
      break;
    const std::size_t z_end = std::min(z + ring, rows_[1] - 1);
    const std::size_t y_end = std::min(y + ring, rows_[0] - 1);
    for (std::size_t at_z = z - std::min(z, ring); at_z <= z_end; ++at_z) {
      const double z_gap = distance(at_z, 2);
      if (z_gap * z_gap > best.squared)
        continue;
      // Inside the ring, only its first and last row at this z.
      const bool whole = at_z + ring == z || at_z == z + ring;
      for (std::size_t at_y = y - std::min(y, ring); at_y <= y_end; ++at_y) {
        if (!whole && at_y + ring != y && at_y != y + ring) {
          at_y = y + ring - 1; // the last row is next
          continue;
        }
        const double y_gap = distance(at_y, 1);
        if (y_gap * y_gap + z_gap * z_gap <= best.squared)
          nearestInRow(at_z * rows_[0] + at_y, query, best);
      }
    }
  }
  return best.index;
}

Indices
UniformGrid::nearestK(const Point& query, std::size_t count) const
{
  if (count == 1 && !points_.empty() && query.allFinite())
    return {nearest(query)};
  std::vector<Neighbor> found;
  nearestK(query, count, row_size_, found);
  Indices result;
  result.reserve(found.size());
  for (const auto& [squared, index] : found)
    result.push_back(index);
  return result;
}

void
UniformGrid::nearestK(const Point& query,
                      std::size_t count,
                      double radius,
                      std::vector<Neighbor>& found) const
{
  found.clear();
  if (points_.empty() || count == 0 || !query.allFinite())
    return;
  count = std::min(count, points_.size());
  const double reach = std::max((query - min_).cwiseAbs().maxCoeff(),
                                (query - max_).cwiseAbs().maxCoeff()) *
                           2 +
                       row_size_;
  std::size_t held = 0;
  const auto keepNearest = [&] {
    if (held <= count)
      return;
    const auto end = found.begin() + static_cast<std::ptrdiff_t>(held);
    held = count;
    std::nth_element(
        found.begin(), found.begin() + static_cast<std::ptrdiff_t>(held) - 1, end);
  };
  const std::size_t most = 2 * count + 16; // held at once
  found.resize(most);
  for (;; radius *= 2) {
    held = 0;
    double wanted = radius * radius;
    const double high = query.x() + radius;
    forEachRow(query, radius, [&](std::size_t sorted_index, std::size_t end) {
      for (; sorted_index < end && points_[sorted_index].x() <= high; ++sorted_index) {
        // Write every point and overwrite unwanted ones: a branch here would be
        // mispredicted every third time.
        const double squared = (points_[sorted_index] - query).squaredNorm();
        found[held] = {squared, indices_[sorted_index]};
        held += squared <= wanted ? 1 : 0;
        if (held == most) {
          keepNearest();
          wanted = found[held - 1].first;
        }
      }
    });
    if (held >= count || radius >= reach)
      break;
  }
  keepNearest();
  found.resize(held);
  std::sort(found.begin(), found.end());
}

} // namespace linelet
