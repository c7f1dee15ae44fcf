// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdio>

#include <linelet/io/output_file.h>
#include <linelet/io/virtual_cloud.h>

#include "cloud_files.h"
#include "commands.h"
#include "frame.h"

namespace linelet::apps {

int
runVpc(const std::vector<std::string>& arguments)
{
  Frame frame("vpc",
              "Writes a virtual point cloud: a list of point files with their extents, "
              "from just their headers. GIS software and every command of linelet "
              "accept it in place of the files.");
  std::string output;
  CloudInput input(frame, CloudInput::Use::Copy);
  frame.addOutput("OUTPUT", output, "file to write, .vpc");
  frame.parse(arguments);
  if (output.size() < 4 || output.compare(output.size() - 4, 4, ".vpc") != 0)
    throw io::FileError(output + ": a virtual point cloud ends in .vpc");
  io::checkWritable(output);

  std::vector<std::string> warnings;
  io::writeVirtualCloud(output, input.headers(), &warnings);
  frame.warn(warnings);
  std::size_t points = 0;
  for (const io::FileSummary& file : input.summaries())
    points += file.points;
  std::printf(
      "%s: %zu files, %zu points\n", output.c_str(), input.files().size(), points);
  frame.summary["files"] = input.files().size();
  frame.summary["points"] = points;
  return frame.finish();
}

} // namespace linelet::apps
