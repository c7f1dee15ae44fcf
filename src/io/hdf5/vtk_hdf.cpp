// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtk_hdf.h"

#include <algorithm>
#include <array>
#include <string>
#include <variant>
#include <vector>

#include "dataset.h"
#include "io/source.h"
#include "layout.h"
#include "staged_hdf5.h"

namespace linelet::io {

using namespace hdf5;

namespace {

constexpr const char* type_name = "UnstructuredGrid";
constexpr std::uint8_t poly_vertex = 2; ///< VTK's cell type

/** \brief Declares the type of the file in the only form that VTK 9.1 accepts: ASCII
 * without a terminator. */
void
setType(const Handle& group)
{
  const std::string what = "write attribute Type";
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, what);
  check(H5Tset_size(type.id(), std::string(type_name).size()), what);
  check(H5Tset_strpad(type.id(), H5T_STR_NULLPAD), what);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, what);
  const Handle attribute(
      H5Acreate2(group.id(), "Type", type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose,
      what);
  check(H5Awrite(attribute.id(), type.id(), type_name), what);
}

/** \brief World coordinates, three per row. */
void
writePlaces(const Handle& group, const Cloud& cloud, const FileWork& work)
{
  const std::string what = "write Points";
  const std::array<hsize_t, 2> size = {cloud.points.size(), 3};
  const std::array<hsize_t, 2> chunk = {
      std::max<hsize_t>(1, std::min<hsize_t>(size[0], 1 << 14)), 3};
  const Handle space(H5Screate_simple(2, size.data(), nullptr), H5Sclose, what);
  const Handle create(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, what);
  check(H5Pset_chunk(create.id(), 2, chunk.data()), what);
  check(H5Pset_shuffle(create.id()), what);
  check(H5Pset_deflate(create.id(), 1), what);
  // No time stamps: the same input gives the same bytes.
  check(H5Pset_obj_track_times(create.id(), false), what);
  const Handle places(H5Dcreate2(group.id(),
                                 "Points",
                                 H5T_IEEE_F64LE,
                                 space.id(),
                                 H5P_DEFAULT,
                                 create.id(),
                                 H5P_DEFAULT),
                      H5Dclose,
                      what);
  std::vector<double> rows;
  for (hsize_t first = 0; first < size[0]; first += chunk[0]) {
    const hsize_t count = std::min(chunk[0], size[0] - first);
    rows.clear();
    for (hsize_t i = first; i < first + count; ++i) {
      const Point p = cloud.shift + cloud.points[i];
      rows.insert(rows.end(), p.data(), p.data() + 3);
    }
    const std::array<hsize_t, 2> from = {first, 0}, many = {count, 3};
    check(H5Sselect_hyperslab(
              space.id(), H5S_SELECT_SET, from.data(), nullptr, many.data(), nullptr),
          what);
    const Handle memory(H5Screate_simple(2, many.data(), nullptr), H5Sclose, what);
    check(H5Dwrite(places.id(),
                   H5T_NATIVE_DOUBLE,
                   memory.id(),
                   space.id(),
                   H5P_DEFAULT,
                   rows.data()),
          what);
    work.advance(count);
  }
}

void
writeAttributes(const Handle& group, const Cloud& cloud)
{
  const Handle data = createGroup(group, "PointData");
  UniqueNames names;
  for (const Column& column : cloud.columns) {
    const ValueType type = typeOf(column);
    Column1D values(
        data, names.take(linkName(column.name)), fileType(type), memoryType(type));
    std::visit([&](const auto& typed) { values.append(typed.data(), typed.size()); },
               column.values);
  }
}

/** \brief All points as one cell. */
void
writeGrid(const Handle& file, const Cloud& cloud, const FileWork& work)
{
  const Handle group = createGroup(file, "VTKHDF");
  setType(group);
  setAttribute(group, "Version", std::vector<std::int64_t>{1, 0});
  if (!cloud.wkt.empty())
    setAttribute(group, "wkt", cloud.wkt);
  const auto count = static_cast<std::int64_t>(cloud.points.size());
  std::vector<std::int64_t> numbers(cloud.points.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    numbers[i] = static_cast<std::int64_t>(i);
  const auto integers = [&](const char* name, const std::vector<std::int64_t>& values) {
    writeValues(group, name, ValueType::Int64, values);
  };
  integers("NumberOfPoints", {count});
  integers("NumberOfCells", {1});
  integers("NumberOfConnectivityIds", {count});
  integers("Connectivity", numbers);
  integers("Offsets", {0, count});
  writeValues(group, "Types", ValueType::UInt8, std::vector<std::uint8_t>{poly_vertex});
  writePlaces(group, cloud, work);
  writeAttributes(group, cloud);
}

} // namespace

void
writeVtkHdf(const Target& target, const Cloud& cloud)
{
  writing(target.name, [&] {
    StagedHdf5 staged(target.name);
    writeGrid(staged.file(), cloud, target);
    staged.publish();
  });
}

} // namespace linelet::io
