// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "text_writer.h"

#include "io/binary_table.h"
#include "io/files.h"
#include "text_rows.h"

namespace linelet::io {

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

} // namespace linelet::io
