// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "cloud_reader.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include <linelet/io/file_error.h>
#include <linelet/io/hdf5_file.h>

#include "curve_grid.h"
#include "io/las/las_format.h"
#include "las_store.h"
#include "layout.h"

namespace linelet::io {

namespace {

using namespace hdf5;

/** \brief A dataset that is a column, or several. */
struct Field {
  std::string link;
  std::int64_t order; ///< of its first column among all
  StoredColumn data;
};

class Reader {
public:
  Reader(const Source& source, Handle file) : source_(source), file_(std::move(file))
  {
    if (!exists(file_, time_slice) || !exists(file_, points_grid) ||
        !exists(file_, points_grid + "/Points") || !exists(file_, chartOf(points_grid)))
      throw Error(std::string("cannot find points in it: there is no group ") +
                  chartOf(points_grid) +
                  ", in which linelet and others that follow the fiber bundle layout "
                  "keep them; convert it with the program that wrote it");
    group_ = openGroup(file_, chartOf(points_grid));
    places_.emplace(group_, positions);
    const auto isNumber = [](const Member& m) { return m.type == ValueType::Float64; };
    if (places_->members().size() != 3 || places_->width() != 1 ||
        !std::all_of(places_->members().begin(), places_->members().end(), isNumber))
      throw Error("cannot read Positions: they are not x, y, z in double");
    findFields();
  }

  std::size_t
  count() const
  {
    return places_->rows();
  }

  std::vector<Hdf5Fragment>
  fragments() const
  {
    if (!exists(group_, hdf5::fragments)) {
      Hdf5Fragment all;
      all.count = count();
      return {all};
    }
    const StoredColumn stored(group_, hdf5::fragments);
    std::vector<Hdf5Fragment> result(stored.rows());
    std::vector<std::uint64_t> numbers(stored.rows());
    std::vector<double> values(stored.rows());
    for (std::size_t m = 0; m < fragmentMembers().size(); ++m) {
      const Member& member = fragmentMembers()[m];
      if (m < 2)
        stored.read(member, 0, numbers.size(), numbers.data());
      else
        stored.read(member, 0, values.size(), values.data());
      for (std::size_t i = 0; i < result.size(); ++i) {
        Hdf5Fragment& part = result[i];
        if (m < 2)
          (m == 0 ? part.first : part.count) = numbers[i];
        else
          (m < 5 ? part.low : part.high)[static_cast<int>((m - 2) % 3)] = values[i];
      }
    }
    for (const Hdf5Fragment& part : result)
      if (part.first > count() || part.count > count() - part.first)
        throw Error("cannot read Fragments: they name points that do not exist");
    return result;
  }

  Cloud
  read(std::size_t first, std::size_t number)
  {
    Cloud cloud;
    cloud.format = "HDF5, fiber bundle";
    cloud.wkt = textAttribute(group_, "wkt");
    cloud.shift = Point(numbersAttribute(group_, "shift", 3).data());
    if (!cloud.shift.allFinite())
      throw Error("its shift is not finite");
    readPlaces(cloud, first, number);
    for (const Field& field : fields_)
      readField(field, cloud, first, number);
    readLas(cloud, first, number);
    return cloud;
  }

private:
  void
  findFields()
  {
    for (const std::string& name : namesIn(group_)) {
      if (name == positions || name == hdf5::fragments)
        continue;
      H5O_info_t info;
      if (H5Oget_info_by_name2(
              group_.id(), name.c_str(), &info, H5O_INFO_BASIC, H5P_DEFAULT) < 0 ||
          info.type != H5O_TYPE_DATASET)
        continue;
      StoredColumn data(group_, name);
      if (data.members().empty() || data.rows() != count() || data.width() != 1) {
        source_.warn("dataset '" + name +
                     "' is not a number for each point and is left out");
        continue;
      }
      const std::int64_t order =
          integerAttribute(data.handle(), "order", std::numeric_limits<int>::max());
      fields_.push_back({name, order, std::move(data)});
    }
    std::stable_sort(fields_.begin(), fields_.end(), [](auto& a, auto& b) {
      return a.order < b.order;
    });
  }

  void
  readPlaces(Cloud& cloud, std::size_t first, std::size_t number)
  {
    cloud.points.resize(number);
    std::vector<double> xyz(3 * std::min(number, block_points));
    const Handle type = compoundType(positionMembers(), false);
    for (std::size_t done = 0; done < number; done += block_points) {
      const std::size_t some = std::min(block_points, number - done);
      places_->readRows(type, first + done, some, xyz.data());
      for (std::size_t i = 0; i < some; ++i)
        cloud.points[done + i] = Point(&xyz[3 * i]);
      source_.advance(some);
    }
  }

  void
  readField(const Field& field, Cloud& cloud, std::size_t first, std::size_t number)
  {
    const bool single = field.data.members().size() == 1;
    for (const Member& member : field.data.members()) {
      Column column;
      column.values = makeValues(member.type, number);
      std::visit(
          [&](auto& values) { field.data.read(member, first, number, values.data()); },
          column.values);
      const std::string name =
          single && member.name.empty()
              ? textAttribute(field.data.handle(), "name", field.link)
          : field.link == tensor ? member.name
                                 : field.link + '_' + member.name;
      column.name = names_.take(cleanName(name).empty() ? "field" : cleanName(name));
      column.description = textAttribute(field.data.handle(), "description");
      cloud.columns.push_back(std::move(column));
    }
  }

  /** The LAS header and records, if intact; otherwise only these are dropped. */
  void
  readLas(Cloud& cloud, std::size_t first, std::size_t number)
  {
    const std::string name = points_grid + "/LAS";
    if (!exists(file_, name))
      return;
    try {
      const Handle group = openGroup(file_, name);
      const auto origin = readLasOrigin(group, cloud);
      for (std::size_t e = 0; e < origin->extras.size(); ++e) {
        LasExtra& extra = origin->extras[e];
        if (!exists(group, rawName(e)))
          continue;
        const StoredColumn raw(group, rawName(e));
        if (raw.rows() != count() * extra.bytes || raw.width() != 1)
          throw Error("its LAS extra bytes do not match its points");
        extra.raw.resize(number * extra.bytes);
        raw.read({"", ValueType::UInt8},
                 first * extra.bytes,
                 extra.raw.size(),
                 extra.raw.data());
      }
      cloud.las = origin;
    }
    catch (const Error& error) {
      source_.warn(std::string(error.what()) +
                   "; scale, offset and records of the LAS file it came from are lost");
    }
  }

  const Source& source_;
  Handle file_, group_;
  std::optional<StoredColumn> places_;
  std::vector<Field> fields_;
  UniqueNames names_;
};

/** \brief Calls \a work with a session; errors of HDF5 name the file. */
template <class Work>
auto
guarded(const std::string& path, Work&& work)
{
  const Session session;
  try {
    return work();
  }
  catch (const Error& error) {
    throw FileError(path + ": " + error.what());
  }
}

} // namespace

Cloud
readHdf5(const Source& source)
{
  return guarded(source.name, [&] {
    std::error_code ignored;
    Handle file = std::filesystem::is_regular_file(source.name, ignored)
                      ? openFile(source.name)
                      : openImage(source.bytes.data(), source.bytes.size());
    Reader reader(source, std::move(file));
    return reader.read(0, reader.count());
  });
}

Cloud
readHdf5Points(const std::string& path,
               std::size_t first,
               std::size_t count,
               std::vector<std::string>* warnings)
{
  Source source;
  source.name = path;
  source.warnings = warnings;
  return guarded(path, [&] {
    Reader reader(source, openFile(path));
    if (first > reader.count() || count > reader.count() - first)
      throw Error("cannot read " + std::to_string(count) + " points from " +
                  std::to_string(first) + " on: it holds " +
                  std::to_string(reader.count()));
    return reader.read(first, count);
  });
}

std::vector<Hdf5Fragment>
hdf5Fragments(const std::string& path)
{
  Source source;
  source.name = path;
  return guarded(path, [&] { return Reader(source, openFile(path)).fragments(); });
}

CurveNetwork
readHdf5Curves(const std::string& path, std::string* wkt)
{
  return guarded(path, [&] { return readCurveGrid(openFile(path), wkt); });
}

} // namespace linelet::io
