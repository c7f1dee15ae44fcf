// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "pcd_writer.h"

#include "io/binary_table.h"

namespace linelet::io {

void
writePcd(const Target& target, const Cloud& cloud)
{
  std::vector<FileColumn> outputs = coordinateColumns(target, cloud, true);
  WordNames names;
  // PCL reads colors from the bits of a float called rgb.
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
  for (const FileColumn& output : outputs) {
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
  writeBinaryRows(file, target, cloud, outputs);
  file.commit();
}

} // namespace linelet::io
