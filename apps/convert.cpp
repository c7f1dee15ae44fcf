// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdio>

#include "cloud_files.h"
#include "commands.h"
#include "frame.h"

namespace linelet::apps {

int
runConvert(const std::vector<std::string>& arguments)
{
  Frame frame("convert",
              "Converts point files, with all attributes that both formats can hold: "
              ".las, .laz, .pcd, .ply, .h5, .xyz, .txt, .csv, and the vertices of "
              ".obj; reads the vertices of vector files (.gpkg, .geojson, .shp, .dxf, "
              "...), writes .vtkhdf for ParaView.");
  CloudInput input(frame, CloudInput::Use::Copy);
  CloudOutput output(frame);
  frame.parse(arguments);
  output.check(input);

  std::size_t points = 0, attributes = 0;
  for (std::size_t i = 0; i < input.files().size(); ++i) {
    const io::Cloud cloud = input.read(i);
    const std::string path = output.pathFor(input, i);
    output.write(cloud, path);
    std::printf("%s: %zu points with %zu attributes\n",
                path.c_str(),
                cloud.points.size(),
                cloud.columns.size());
    points += cloud.points.size();
    attributes = cloud.columns.size();
  }
  frame.summary["points"] = points;
  frame.summary["attributes"] = attributes;
  return frame.finish();
}

} // namespace linelet::apps
