// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <optional>

#include <linelet/io/file_error.h>
#include <linelet/io/hdf5_file.h>

#include "curve_grid.h"
#include "io/files.h"
#include "io/las/las_format.h"
#include "io/source.h"
#include "io/staged_file.h"
#include "io/writers.h"
#include "las_store.h"
#include "layout.h"

namespace linelet::io {

namespace {

using namespace hdf5;

/** \brief A dataset, and which columns of a cloud its members are. */
struct Field {
  std::vector<std::size_t> columns; ///< one, or the entries of a tensor
  ValueType type;
  Column1D data;
};

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

/** \brief \a name as that of a link, in which a slash and a lone dot mean more. */
std::string
linkName(const std::string& name)
{
  std::string link = name;
  std::replace(link.begin(), link.end(), '/', '_');
  return link.empty() || link == "." ? "_" : link;
}

/** \brief The bytes of extra bytes that columns cannot tell, in the file from the first
 * block on that has any. */
struct RawExtra {
  std::size_t bytes;
  std::optional<Column1D> data;
};

} // namespace

struct Hdf5CloudWriter::File {
  File(const std::string& file_path, const Cloud& like)
      : path(file_path), shift(like.shift), staged(file_path)
  {
    if (staged.direct())
      throw FileError(path +
                      ": HDF5 is written to files only, not to devices or pipes");
    file = createFile(staged.place());
    Handle slice = createGroup(file, time_slice);
    setAttribute(slice, "Time", std::vector<double>{0});
    if (!like.points.empty() || !like.columns.empty() || like.las != nullptr)
      beginPoints(like);
  }

  void
  beginPoints(const Cloud& like)
  {
    group = createGroup(file, chartOf(points_grid));
    setAttribute(group, "shift", std::vector<double>{shift.x(), shift.y(), shift.z()});
    if (!like.wkt.empty())
      setAttribute(group, "wkt", like.wkt);
    places.emplace(positionColumn(group));
    parts.emplace(group,
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
    las = createGroup(file, points_grid + "/LAS");
    writeLasOrigin(las, *like.las);
    for (const LasExtra& extra : like.las->extras)
      raw.push_back({extra.bytes, {}});
  }

  /** \return number of columns that it holds */
  std::size_t
  beginField(const Cloud& like, std::size_t first, UniqueNames& names)
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
      fields.push_back({columns,
                        type,
                        Column1D(group,
                                 tensor,
                                 compoundType(members, true).id(),
                                 compoundType(members, false).id())});
    }
    else
      fields.push_back({{first},
                        type,
                        Column1D(group,
                                 names.take(linkName(column.name)),
                                 fileType(type),
                                 memoryType(type))});
    const Field& field = fields.back();
    setAttribute(field.data.handle(), "order", std::vector<std::int64_t>{order});
    if (field.columns.size() == 1)
      setAttribute(field.data.handle(), "name", column.name);
    if (!column.description.empty())
      setAttribute(field.data.handle(), "description", column.description);
    form.reserve(like.columns.size());
    for (const std::size_t i : field.columns)
      form.push_back({like.columns[i].name, makeValues(type, 0), {}});
    return field.columns.size();
  }

  void
  append(const Cloud& cloud, std::size_t first, std::size_t count)
  {
    checkForm(cloud);
    if (count == 0)
      return;
    std::vector<double> xyz(3 * count);
    std::array<double, 6> box;
    std::fill_n(box.begin(), 3, std::numeric_limits<double>::infinity());
    std::fill_n(box.begin() + 3, 3, -std::numeric_limits<double>::infinity());
    const Point move = cloud.shift - shift;
    for (std::size_t i = 0; i < count; ++i) {
      const Point p = move + cloud.points[first + i];
      for (int axis = 0; axis < 3; ++axis) {
        xyz[3 * i + static_cast<std::size_t>(axis)] = p[axis];
        if (!p.allFinite())
          continue;
        double& low = box[static_cast<std::size_t>(axis)];
        double& high = box[static_cast<std::size_t>(axis) + 3];
        low = std::min(low, shift[axis] + p[axis]);
        high = std::max(high, shift[axis] + p[axis]);
      }
    }
    places->append(xyz.data(), count);
    for (Field& field : fields)
      appendField(field, cloud, first, count);
    appendRaw(cloud, first, count);
    appendFragment(count, box);
    written += count;
  }

  void
  checkForm(const Cloud& cloud) const
  {
    bool same = places && cloud.columns.size() == form.size();
    for (std::size_t i = 0; same && i < form.size(); ++i)
      same = cloud.columns[i].name == form[i].name &&
             typeOf(cloud.columns[i]) == typeOf(form[i]);
    if (!same)
      throw FileError(path + ": a block of points does not have the attributes of the "
                             "others; give all of them the same");
  }

  static void
  appendField(Field& field, const Cloud& cloud, std::size_t first, std::size_t count)
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
  appendRaw(const Cloud& cloud, std::size_t first, std::size_t count)
  {
    for (std::size_t e = 0; e < raw.size(); ++e) {
      const bool has =
          cloud.las != nullptr && e < cloud.las->extras.size() &&
          cloud.las->extras[e].bytes == raw[e].bytes &&
          cloud.las->extras[e].raw.size() == raw[e].bytes * cloud.points.size();
      if (!has && !raw[e].data)
        continue;
      const std::size_t length = raw[e].bytes;
      if (!raw[e].data) {
        raw[e].data.emplace(las, rawName(e), H5T_STD_U8LE, H5T_NATIVE_UINT8);
        appendZeros(*raw[e].data, written * length);
      }
      if (has)
        raw[e].data->append(cloud.las->extras[e].raw.data() + first * length,
                            count * length);
      else
        appendZeros(*raw[e].data, count * length);
    }
  }

  /** \brief Bytes that no column can agree with but by chance, and then rightly. */
  static void
  appendZeros(Column1D& data, std::size_t count)
  {
    constexpr std::size_t block = 1 << 20;
    const std::string zeros(std::min(count, block), '\0');
    for (std::size_t left = count; left > 0; left -= std::min(left, block))
      data.append(zeros.data(), std::min(left, block));
  }

  void
  appendFragment(std::size_t count, const std::array<double, 6>& box)
  {
    struct {
      std::uint64_t first, count;
      std::array<double, 6> box;
    } entry = {written, count, box};
    static_assert(sizeof entry == 64);
    parts->append(&entry, 1);
  }

  /** \brief Calls \a work; what HDF5 cannot do names the file. */
  template <class Work>
  void
  guarded(Work&& work)
  {
    const Session session;
    try {
      work();
    }
    catch (const Error& error) {
      throw FileError(path + ": " + error.what() +
                      "; check that there is room on the disk");
    }
  }

  void
  commit()
  {
    check(H5Fflush(file.id(), H5F_SCOPE_GLOBAL), "write it");
    close();
    if (!file.reset())
      throw Error("cannot write it");
    staged.publish();
  }

  /** \brief Gives back all that is open but the file. */
  void
  close()
  {
    fields.clear();
    raw.clear();
    places.reset();
    parts.reset();
    group.reset();
    las.reset();
  }

  std::string path;
  Point shift;
  StagedFile staged;
  Handle file, group, las;
  std::optional<Column1D> places, parts;
  std::vector<Field> fields;
  std::vector<Column> form; ///< names and types
  std::vector<RawExtra> raw;
  std::uint64_t written = 0;
};

bool
hasHdf5()
{
  return true;
}

Hdf5CloudWriter::Hdf5CloudWriter(const std::string& path, const Cloud& like)
{
  const Session session;
  try {
    file_ = std::make_unique<File>(path, like);
  }
  catch (const Error& error) {
    throw FileError(path + ": " + error.what() +
                    "; check that the folder exists, may be written and has room");
  }
}

Hdf5CloudWriter::~Hdf5CloudWriter()
{
  const Session session;
  file_.reset();
}

void
Hdf5CloudWriter::append(const Cloud& block)
{
  append(block, 0, block.points.size());
}

void
Hdf5CloudWriter::append(const Cloud& cloud, std::size_t first, std::size_t count)
{
  file_->guarded([&] { file_->append(cloud, first, count); });
}

void
Hdf5CloudWriter::add(const CurveNetwork& network, const Point& shift)
{
  file_->guarded([&] { writeCurveGrid(file_->file, network, shift, {}); });
}

void
Hdf5CloudWriter::commit()
{
  file_->guarded([&] { file_->commit(); });
}

namespace {

/// Points of a fragment of a cloud that is in memory as a whole: few enough to be
/// skipped by their box, many enough to compress well.
constexpr std::size_t fragment_points = 1 << 18;

void
appendAll(Hdf5CloudWriter& writer, const Cloud& cloud, const FileWork& work)
{
  for (std::size_t first = 0; first < cloud.points.size(); first += fragment_points) {
    const std::size_t count = std::min(fragment_points, cloud.points.size() - first);
    writer.append(cloud, first, count);
    work.advance(count);
  }
}

} // namespace

void
writeHdf5(const Target& target, const Cloud& cloud)
{
  Hdf5CloudWriter writer(target.name, cloud);
  appendAll(writer, cloud, target);
  writer.commit();
}

void
writeHdf5(const std::string& path,
          const Cloud& cloud,
          const CurveNetwork& network,
          ProgressMonitor* monitor)
{
  Hdf5CloudWriter writer(path, cloud);
  appendAll(writer, cloud, {path, nullptr, monitor});
  writer.add(network, cloud.shift);
  writer.commit();
}

void
writeHdf5Curves(const std::string& path,
                const CurveNetwork& network,
                const Point& shift,
                const std::string& wkt)
{
  const Session session;
  try {
    StagedFile staged(path);
    if (staged.direct())
      throw FileError(path +
                      ": HDF5 is written to files only, not to devices or pipes");
    Handle file = createFile(staged.place());
    setAttribute(createGroup(file, time_slice), "Time", std::vector<double>{0});
    writeCurveGrid(file, network, shift, wkt);
    check(H5Fflush(file.id(), H5F_SCOPE_GLOBAL), "write it");
    if (!file.reset())
      throw Error("cannot write it");
    staged.publish();
  }
  catch (const Error& error) {
    throw FileError(path + ": " + error.what() +
                    "; check that the folder exists, may be written and has room");
  }
}

} // namespace linelet::io
