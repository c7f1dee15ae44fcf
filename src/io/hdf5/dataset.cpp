// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "dataset.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace linelet::io::hdf5 {

namespace {

/// Rows of a chunk: large enough to compress well, few enough to hold a chunk of every
/// attribute in memory.
constexpr hsize_t chunk_rows = 16384;
constexpr unsigned deflate_level = 4;

/// Largest ratio of deflate.
constexpr double most_inflation = 1032;

std::vector<Member>
membersOf(hid_t type)
{
  if (const auto single = valueType(type))
    return {{"", *single}};
  if (H5Tget_class(type) != H5T_COMPOUND)
    return {};
  std::vector<Member> members;
  const int count = H5Tget_nmembers(type);
  for (int i = 0; i < count; ++i) {
    const auto number = static_cast<unsigned>(i);
    const Handle member(H5Tget_member_type(type, number), H5Tclose, "read a type");
    const auto kind = valueType(member.id());
    char* name = H5Tget_member_name(type, number);
    if (kind && name != nullptr)
      members.push_back({name, *kind});
    H5free_memory(name);
  }
  return members.size() == static_cast<std::size_t>(count) ? members
                                                           : std::vector<Member>();
}

} // namespace

Handle
compoundType(const std::vector<Member>& members, bool in_file)
{
  std::size_t size = 0;
  for (const Member& member : members)
    size += sizeOf(member.type);
  Handle type(H5Tcreate(H5T_COMPOUND, size), H5Tclose, "make a type");
  std::size_t at = 0;
  for (const Member& member : members) {
    check(H5Tinsert(type.id(),
                    member.name.c_str(),
                    at,
                    in_file ? fileType(member.type) : memoryType(member.type)),
          "make a type");
    at += sizeOf(member.type);
  }
  return type;
}

Column1D::Column1D(const Handle& group,
                   const std::string& name,
                   hid_t file_type,
                   hid_t memory_type)
    : name_(name), memory_type_(H5Tcopy(memory_type), H5Tclose, "write " + name)
{
  const std::string what = "write " + name;
  const hsize_t none = 0, unlimited = H5S_UNLIMITED;
  const Handle space(H5Screate_simple(1, &none, &unlimited), H5Sclose, what);
  const Handle create(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, what);
  check(H5Pset_chunk(create.id(), 1, &chunk_rows), what);
  check(H5Pset_shuffle(create.id()), what);
  check(H5Pset_deflate(create.id(), deflate_level), what);
  // No time stamps: the same input gives the same bytes.
  check(H5Pset_obj_track_times(create.id(), false), what);
  dataset_ = Handle(H5Dcreate2(group.id(),
                               name.c_str(),
                               file_type,
                               space.id(),
                               H5P_DEFAULT,
                               create.id(),
                               H5P_DEFAULT),
                    H5Dclose,
                    what);
}

void
Column1D::append(const void* values, std::size_t count)
{
  if (count == 0)
    return;
  const std::string what = "write " + name_;
  const hsize_t first = size_, number = count;
  size_ += count;
  check(H5Dset_extent(dataset_.id(), &size_), what);
  const Handle file(H5Dget_space(dataset_.id()), H5Sclose, what);
  check(
      H5Sselect_hyperslab(file.id(), H5S_SELECT_SET, &first, nullptr, &number, nullptr),
      what);
  const Handle memory(H5Screate_simple(1, &number, nullptr), H5Sclose, what);
  check(H5Dwrite(dataset_.id(),
                 memory_type_.id(),
                 memory.id(),
                 file.id(),
                 H5P_DEFAULT,
                 values),
        what);
}

namespace {

/** \brief Rejects a record whose fields overlap or exceed it: HDF5 1.10 trusts them
 * when it converts, and reads and writes outside its buffers. */
void
checkRecord(hid_t type, const std::string& name)
{
  if (H5Tget_class(type) != H5T_COMPOUND)
    return;
  std::vector<std::pair<std::size_t, std::size_t>> fields; // begin, end
  for (int i = 0; i < H5Tget_nmembers(type); ++i) {
    const auto number = static_cast<unsigned>(i);
    const Handle field(H5Tget_member_type(type, number), H5Tclose, "read " + name);
    const std::size_t begin = H5Tget_member_offset(type, number);
    fields.emplace_back(begin, begin + H5Tget_size(field.id()));
  }
  std::sort(fields.begin(), fields.end());
  std::size_t end = 0;
  for (const auto& [begin, next] : fields) {
    if (begin < end || next > H5Tget_size(type))
      throw Error("cannot read " + name + ": the fields of its records are damaged");
    end = next;
  }
}

} // namespace

StoredColumn::StoredColumn(const Handle& group, const std::string& name) : name_(name)
{
  const std::string what = "read " + name;
  dataset_ = Handle(H5Dopen2(group.id(), name.c_str(), H5P_DEFAULT), H5Dclose, what);
  const Handle space(H5Dget_space(dataset_.id()), H5Sclose, what);
  const Handle type(H5Dget_type(dataset_.id()), H5Tclose, what);
  const int dimensions = H5Sget_simple_extent_ndims(space.id());
  if (dimensions < 1 || dimensions > 2)
    return;
  hsize_t extent[2] = {0, 1};
  check(H5Sget_simple_extent_dims(space.id(), extent, nullptr), what);
  checkRecord(type.id(), name);
  members_ = membersOf(type.id());
  const double bytes = static_cast<double>(extent[0]) * static_cast<double>(extent[1]) *
                       static_cast<double>(H5Tget_size(type.id()));
  const double stored = static_cast<double>(H5Dget_storage_size(dataset_.id()));
  if (bytes > most_inflation * stored + 4096)
    throw Error("cannot read " + name + ": it claims " + std::to_string(extent[0]) +
                " rows, more than its bytes can hold");
  const Handle create(H5Dget_create_plist(dataset_.id()), H5Pclose, what);
  if (H5Pget_layout(create.id()) == H5D_COMPACT && stored < bytes)
    throw Error("cannot read " + name + ": it is damaged");
  chunks_ = ChunkCheck(dataset_, extent[1], H5Tget_size(type.id()), name);
  rows_ = extent[0];
  width_ = extent[1];
}

void
StoredColumn::read(hid_t memory_type,
                   std::size_t first,
                   std::size_t count,
                   void* values) const
{
  if (count == 0)
    return;
  const std::string what = "read " + name_;
  chunks_.rows(dataset_, first, count);
  const Handle file(H5Dget_space(dataset_.id()), H5Sclose, what);
  const hsize_t begin[2] = {first, 0}, number[2] = {count, width_};
  check(H5Sselect_hyperslab(file.id(), H5S_SELECT_SET, begin, nullptr, number, nullptr),
        what);
  const hsize_t total = count * width_;
  const Handle memory(H5Screate_simple(1, &total, nullptr), H5Sclose, what);
  check(
      H5Dread(dataset_.id(), memory_type, memory.id(), file.id(), H5P_DEFAULT, values),
      what + ": it is damaged");
}

void
StoredColumn::read(const Member& member,
                   std::size_t first,
                   std::size_t count,
                   void* values) const
{
  if (member.name.empty())
    return read(memoryType(member.type), first, count, values);
  const Handle type = compoundType({member}, false);
  read(type.id(), first, count, values);
}

} // namespace linelet::io::hdf5
