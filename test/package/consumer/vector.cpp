// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/point_file.h>
#include <linelet/io/vector_file.h>

int
main()
{
  const linelet::io::Cloud cloud = linelet::io::readCloud(DATA "/corridor.las");
  if (linelet::io::referenceName(cloud.wkt).empty())
    return 1;
  linelet::io::VectorLayer layer;
  layer.name = "line";
  layer.features.push_back({{{0, 0, 0}, {1, 1, 1}}, {}, {}, {}});
  linelet::io::writeLayers("line.gpkg", {layer}, cloud.wkt);
  return 0;
}
