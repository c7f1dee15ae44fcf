// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ply_writer.h"

#include "io/binary_table.h"

namespace linelet::io {

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
  std::vector<FileColumn> outputs = coordinateColumns(target, cloud, false);
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
  for (const FileColumn& output : outputs)
    header += std::string("property ") + types[static_cast<std::size_t>(output.type)] +
              ' ' + output.name + '\n';
  file.write(header + "end_header\n");
  writeBinaryRows(file, target, cloud, outputs);
  file.commit();
}

} // namespace linelet::io
