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
              ".las, .pcd, .ply, .xyz, .txt, .csv, and the vertices of .obj.");
  CloudInput input(frame, CloudInput::Use::Copy);
  CloudOutput output(frame);
  frame.parse(arguments);
  output.check();

  const io::Cloud cloud = input.read();
  output.write(cloud);
  std::printf("%s: %zu points with %zu attributes\n",
              output.path().c_str(),
              cloud.points.size(),
              cloud.columns.size());
  frame.summary["points"] = cloud.points.size();
  frame.summary["attributes"] = cloud.columns.size();
  return frame.finish();
}

} // namespace linelet::apps
