// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "obj_vertices.h"

#include <array>
#include <utility>
#include <vector>

#include "io/columns.h"
#include "io/text_scan.h"
#include "text_rows.h"

namespace linelet::io {

Cloud
readObjVertices(const Source& source)
{
  std::array<std::vector<double>, 3> places;
  Lines lines(source.bytes);
  for (std::string_view line; lines.next(line);) {
    if (takeWord(line) != "v")
      continue;
    for (std::vector<double>& values : places) {
      double value = 0;
      if (!parseNumber(takeWord(line), value))
        source.fail("line " + std::to_string(lines.number()) +
                    ": a vertex needs three numbers");
      values.push_back(value);
    }
  }
  if (places[0].empty())
    source.fail("there are no vertices (lines that begin with 'v')");
  Cloud cloud = cloudFromColumns(source,
                                 {{"x", std::move(places[0]), {}},
                                  {"y", std::move(places[1]), {}},
                                  {"z", std::move(places[2]), {}}});
  cloud.format = "OBJ";
  return cloud;
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
