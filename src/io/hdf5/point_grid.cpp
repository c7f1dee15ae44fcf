// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "point_grid.h"

#include <algorithm>
#include <limits>
#include <string>
#include <variant>

#include "las_store.h"
#include "layout.h"

namespace linelet::io {

using namespace hdf5;

namespace {

/** \brief Whether the six columns from \a first on are the entries of a tensor. */
bool
isTensor(const Cloud& cloud, std::size_t first)
{
  for (std::size_t k = 0; k < tensor_entries.size(); ++k)
    if (first + k >= cloud.columns.size() ||
        cloud.columns[first + k].name != tensor_entries[k] ||
        typeOf(cloud.columns[first + k]) != typeOf(cloud.columns[first]))
      return false;
  return true;
}

} // namespace

PointGrid::PointGrid(const Handle& file, const Cloud& like) : shift_(like.shift)
{
  group_ = createGroup(file, chartOf(points_grid));
  setAttribute(
      group_, "shift", std::vector<double>{shift_.x(), shift_.y(), shift_.z()});
  if (!like.wkt.empty())
    setAttribute(group_, "wkt", like.wkt);
  places_.emplace(positionColumn(group_));
  fragments_.emplace(group_,
                     fragments,
                     compoundType(fragmentMembers(), true).id(),
                     compoundType(fragmentMembers(), false).id());
  UniqueNames names;
  for (const char* taken : {positions, fragments, tensor})
    names.take(taken);
  for (std::size_t i = 0; i < like.columns.size();)
    i += beginField(like, i, names);
  if (like.las == nullptr)
    return;
  las_ = createGroup(file, points_grid + "/LAS");
  writeLasOrigin(las_, *like.las);
  raw_.emplace(*like.las);
}

std::size_t
PointGrid::beginField(const Cloud& like, std::size_t first, UniqueNames& names)
{
  const Column& column = like.columns[first];
  const ValueType type = typeOf(column);
  const auto order = static_cast<std::int64_t>(first);
  if (isTensor(like, first)) {
    std::vector<Member> members;
    std::vector<std::size_t> columns;
    for (std::size_t k = 0; k < tensor_entries.size(); ++k) {
      members.push_back({std::string(tensor_entries[k]), type});
      columns.push_back(first + k);
    }
    fields_.push_back({columns,
                       type,
                       Column1D(group_,
                                tensor,
                                compoundType(members, true).id(),
                                compoundType(members, false).id())});
  }
  else
    fields_.push_back({{first},
                       type,
                       Column1D(group_,
                                names.take(linkName(column.name)),
                                fileType(type),
                                memoryType(type))});
  const Field& field = fields_.back();
  setAttribute(field.data.handle(), "order", std::vector<std::int64_t>{order});
  if (field.columns.size() == 1)
    setAttribute(field.data.handle(), "name", column.name);
  if (!column.description.empty())
    setAttribute(field.data.handle(), "description", column.description);
  form_.reserve(like.columns.size());
  for (const std::size_t i : field.columns)
    form_.push_back({like.columns[i].name, makeValues(type, 0), {}});
  return field.columns.size();
}

bool
PointGrid::fits(const Cloud& cloud) const
{
  bool same = cloud.columns.size() == form_.size();
  for (std::size_t i = 0; same && i < form_.size(); ++i)
    same = cloud.columns[i].name == form_[i].name &&
           typeOf(cloud.columns[i]) == typeOf(form_[i]);
  return same;
}

void
PointGrid::append(const Cloud& cloud, std::size_t first, std::size_t count)
{
  if (count == 0)
    return;
  std::vector<double> xyz(3 * count);
  std::array<double, 6> box;
  std::fill_n(box.begin(), 3, std::numeric_limits<double>::infinity());
  std::fill_n(box.begin() + 3, 3, -std::numeric_limits<double>::infinity());
  const Point move = cloud.shift - shift_;
  for (std::size_t i = 0; i < count; ++i) {
    const Point p = move + cloud.points[first + i];
    for (int axis = 0; axis < 3; ++axis) {
      xyz[3 * i + static_cast<std::size_t>(axis)] = p[axis];
      if (!p.allFinite())
        continue;
      double& low = box[static_cast<std::size_t>(axis)];
      double& high = box[static_cast<std::size_t>(axis) + 3];
      low = std::min(low, shift_[axis] + p[axis]);
      high = std::max(high, shift_[axis] + p[axis]);
    }
  }
  places_->append(xyz.data(), count);
  for (Field& field : fields_)
    appendField(field, cloud, first, count);
  if (raw_)
    raw_->append(las_, cloud, first, count, written_);
  appendFragment(count, box);
  written_ += count;
}

void
PointGrid::appendField(Field& field,
                       const Cloud& cloud,
                       std::size_t first,
                       std::size_t count)
{
  withType(field.type, [&](auto zero) {
    using T = decltype(zero);
    const auto valuesOf = [&](std::size_t k) {
      return std::get<std::vector<T>>(cloud.columns[field.columns[k]].values).data() +
             first;
    };
    const std::size_t width = field.columns.size();
    if (width == 1)
      return field.data.append(valuesOf(0), count);
    std::vector<T> rows(width * count);
    for (std::size_t k = 0; k < width; ++k)
      for (std::size_t i = 0; i < count; ++i)
        rows[i * width + k] = valuesOf(k)[i];
    field.data.append(rows.data(), count);
  });
}

void
PointGrid::appendFragment(std::size_t count, const std::array<double, 6>& box)
{
  struct {
    std::uint64_t first, count;
    std::array<double, 6> box;
  } entry = {written_, count, box};
  static_assert(sizeof entry == 64);
  fragments_->append(&entry, 1);
}

} // namespace linelet::io
