// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// The formats that are tables with named columns: PCD, PLY and text.

#include <algorithm>

#include "columns.h"
#include "coordinate_form.h"
#include "files.h"
#include "io/text/text_scan.h"
#include "writers.h"

namespace linelet::io {

namespace {

/** A column of the output: an attribute, a coordinate or a packed color. */
struct Output {
  std::string name;
  ValueType type;
  const Column* column = nullptr; ///< null: coordinate \a axis
  int axis = 0;
};

/** Rows of little-endian values. */
class BinaryTable {
public:
  BinaryTable(const Target& target, const Cloud& cloud, std::vector<Output> outputs)
      : target_(target), cloud_(cloud), outputs_(std::move(outputs))
  {
    for (const Output& output : outputs_)
      row_bytes_ += sizeOf(output.type);
  }

  void
  write(OutputFile& file) const
  {
    std::string rows;
    for (std::size_t first = 0; first < cloud_.points.size(); first += block_points) {
      const std::size_t count = std::min(block_points, cloud_.points.size() - first);
      rows.resize(count * row_bytes_);
      char* at = rows.data();
      for (const Output& output : outputs_) {
        fill(output, at, first, count);
        at += sizeOf(output.type);
      }
      file.write(rows);
      target_.advance(count);
    }
  }

private:
  void
  fill(const Output& output, char* at, std::size_t first, std::size_t count) const
  {
    withType(output.type, [&](auto zero) {
      using T = decltype(zero);
      if (output.column == nullptr) {
        for (std::size_t i = 0; i < count; ++i, at += row_bytes_)
          store(at,
                static_cast<T>(cloud_.shift[output.axis] +
                               cloud_.points[first + i][output.axis]));
        return;
      }
      std::visit(
          [&](const auto& values) {
            for (std::size_t i = 0; i < count; ++i, at += row_bytes_)
              store(at, nearest<T>(values[first + i]));
          },
          output.column->values);
    });
  }

  const Target& target_;
  const Cloud& cloud_;
  std::vector<Output> outputs_;
  std::size_t row_bytes_ = 0;
};

/** Names as words, each its own; x, y and z are taken. */
class WordNames {
public:
  WordNames()
  {
    for (const char* name : {"x", "y", "z"})
      names_.take(name);
  }

  std::string
  take(const std::string& asked)
  {
    return names_.take(wordName(asked));
  }

private:
  UniqueNames names_;
};

std::vector<Output>
coordinates(const Target& target, const Cloud& cloud, bool pcl)
{
  const bool floats = formOf(cloud).fits_float;
  if (!floats && pcl)
    target.warn(
        "x, y and z are written with 8 bytes, as 4 cannot hold them; PCL's point "
        "types do not read such fields (linelet convert --shifted writes what they "
        "do)");
  const ValueType type = floats ? ValueType::Float32 : ValueType::Float64;
  return {{"x", type, nullptr, 0}, {"y", type, nullptr, 1}, {"z", type, nullptr, 2}};
}

/** The cloud's 8 bit colors as columns. */
std::vector<Column>
colorColumns(const Cloud& cloud)
{
  std::vector<Column> columns;
  if (auto colors = byteColors(cloud))
    for (std::size_t i = 0; i < 3; ++i)
      columns.push_back(
          {std::array<const char*, 3>{"red", "green", "blue"}[i], (*colors)[i], {}});
  return columns;
}

/** One word for a text in a header line. */
std::string
oneLine(std::string text)
{
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

/** Appends the world coordinates of point \a i. */
void
appendPlace(std::string& text,
            const Cloud& cloud,
            std::size_t i,
            const CoordinateForm& form,
            char gap)
{
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0)
      text += gap;
    appendCoordinate(text, cloud.shift[axis] + cloud.points[i][axis], form);
  }
}

/** Writes a file of \a header and a line for each point, to which \a append_row gives
 * its words. */
template <class AppendRow>
void
writeRows(const Target& target,
          const std::string& header,
          std::size_t points,
          AppendRow append_row)
{
  OutputFile file(target.name);
  std::string text = header;
  for (std::size_t i = 0; i < points; ++i) {
    append_row(text, i);
    text += '\n';
    if (i % block_points == block_points - 1) {
      file.write(text);
      text.clear();
      target.advance(block_points);
    }
  }
  file.write(text);
  file.commit();
}

} // namespace

void
writePcd(const Target& target, const Cloud& cloud)
{
  std::vector<Output> outputs = coordinates(target, cloud, true);
  WordNames names;
  // PCL reads colors as the bits of a float called rgb.
  const std::vector<Column> colors = colorColumns(cloud);
  Column packed{"rgb", std::vector<std::uint32_t>(), {}};
  if (!colors.empty()) {
    auto& bits = std::get<std::vector<std::uint32_t>>(packed.values);
    bits.assign(cloud.points.size(), 0);
    for (const Column& color : colors)
      for (std::size_t i = 0; i < bits.size(); ++i)
        bits[i] = bits[i] << 8 | std::get<std::vector<std::uint8_t>>(color.values)[i];
    outputs.push_back({names.take("rgb"), ValueType::UInt32, &packed});
  }
  for (const Column& column : cloud.columns)
    if (colors.empty() || !isColor(column.name))
      outputs.push_back({names.take(column.name), typeOf(column), &column});

  std::string fields = "FIELDS", sizes = "SIZE", types = "TYPE", counts = "COUNT";
  for (const Output& output : outputs) {
    const bool rgb = output.column == &packed;
    const auto index = static_cast<std::size_t>(output.type);
    fields += ' ' + output.name;
    sizes += ' ' + std::to_string(sizeOf(output.type));
    types += std::string(" ") + (rgb ? 'F' : "IUIUIUIUFF"[index]);
    counts += " 1";
  }
  const std::string points = std::to_string(cloud.points.size());
  OutputFile file(target.name);
  file.write("# .PCD v0.7 - Point Cloud Data file format\n");
  if (!cloud.wkt.empty())
    file.write("# crs " + oneLine(cloud.wkt) + '\n');
  file.write("VERSION 0.7\n" + fields + '\n' + sizes + '\n' + types + '\n' + counts +
             "\nWIDTH " + points + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
             points + "\nDATA binary\n");
  BinaryTable(target, cloud, outputs).write(file);
  file.commit();
}

void
writePly(const Target& target, const Cloud& cloud)
{
  static constexpr const char* types[] = {"char",
                                          "uchar",
                                          "short",
                                          "ushort",
                                          "int",
                                          "uint",
                                          "double",
                                          "double",
                                          "float",
                                          "double"};
  std::vector<Output> outputs = coordinates(target, cloud, false);
  WordNames names;
  const std::vector<Column> colors = colorColumns(cloud);
  for (const Column& column : cloud.columns) {
    const Column* source = &column;
    for (const Column& color : colors)
      if (color.name == column.name)
        source = &color;
    std::string name = column.name;
    if (name.rfind("normal_", 0) == 0 && name.size() == 8)
      name = std::string("n") + name.back();
    else if (!isColor(name) && name != "intensity")
      name.insert(0, scalar_prefix); // PLY has a convention for the others
    ValueType type = typeOf(*source);
    if (type == ValueType::Int64 || type == ValueType::UInt64) {
      type = ValueType::Float64; // PLY has no integers of 8 bytes
      target.warn("attribute '" + name +
                  "' is written as double, as PLY has no integers "
                  "of 8 bytes; values above 2^53 are rounded");
    }
    outputs.push_back({names.take(name), type, source});
  }
  OutputFile file(target.name);
  std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment written by linelet\n";
  if (!cloud.wkt.empty())
    header += "comment crs " + oneLine(cloud.wkt) + '\n';
  header += "element vertex " + std::to_string(cloud.points.size()) + '\n';
  for (const Output& output : outputs)
    header += std::string("property ") + types[static_cast<std::size_t>(output.type)] +
              ' ' + output.name + '\n';
  file.write(header + "end_header\n");
  BinaryTable(target, cloud, outputs).write(file);
  file.commit();
}

void
writeText(const Target& target, const Cloud& cloud)
{
  const bool csv = endingOf(target.name) == ".csv";
  const char gap = csv ? ',' : ' ';
  if (!cloud.wkt.empty())
    target.warn("text cannot hold the reference system");
  const CoordinateForm form = formOf(cloud);
  WordNames names;
  std::string text = csv ? "x,y,z" : "# x y z";
  for (const Column& column : cloud.columns)
    text += gap + names.take(column.name);
  text += '\n';
  if (!csv && cloud.columns.empty())
    text.clear();
  writeRows(target, text, cloud.points.size(), [&](std::string& row, std::size_t i) {
    appendPlace(row, cloud, i, form, gap);
    for (const Column& column : cloud.columns) {
      row += gap;
      appendValue(row, column, i);
    }
  });
}

void
writeObjVertices(const Target& target, const Cloud& cloud)
{
  if (!cloud.columns.empty())
    target.warn("OBJ holds vertices only; " + std::to_string(cloud.columns.size()) +
                " attributes are left out");
  const CoordinateForm form = formOf(cloud);
  const std::string header = "# points, written by linelet\n";
  writeRows(target, header, cloud.points.size(), [&](std::string& row, std::size_t i) {
    row += "v ";
    appendPlace(row, cloud, i, form, ' ');
  });
}

} // namespace linelet::io
