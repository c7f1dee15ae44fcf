// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdio>

#include <linelet/io/output_check.h>
#include <linelet/io/point_file.h>

#include "commands.h"
#include "frame.h"
#include "options.h"

namespace linelet::apps {

int
runConvert(const std::vector<std::string>& arguments)
{
  Frame frame("convert", "Convert between .las, .pcd, .ply, .xyz, .txt, .csv and .obj");
  std::string in, out;
  io::ReadOptions options;
  io::WriteOptions writing;
  frame.app.add_option("IN", in, "point file")->required();
  frame.app.add_option("OUT", out, "point file, in the format of its ending")
      ->required();
  addOptions(frame.app, options);
  addOptions(frame.app, writing);
  frame.parse(arguments);
  io::checkCloudOutput(out);

  std::vector<std::string> warnings;
  const io::Cloud cloud = io::readCloud(in, options, &warnings, &frame.monitor);
  io::writeCloud(out, cloud, writing, &warnings, &frame.monitor);
  frame.warn(warnings);
  std::printf("%zu points with %zu attributes: %s\n",
              cloud.points.size(),
              cloud.columns.size(),
              out.c_str());
  frame.summary["points"] = cloud.points.size();
  frame.summary["attributes"] = cloud.columns.size();
  frame.summary["warnings"] = warnings;
  return frame.finish();
}

} // namespace linelet::apps
