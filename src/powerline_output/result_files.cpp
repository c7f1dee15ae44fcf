// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/powerline_output/result_files.h>

#include <filesystem>

namespace linelet::powerline {

std::vector<std::string>
powerLineFiles(const std::string& folder, bool compress)
{
  std::vector<std::string> paths;
  for (const char* name : {compress ? "classified.laz" : "classified.las",
                           "wires.geojson",
                           "wires.gpkg",
                           "wires.dxf",
                           "hazards.geojson",
                           "hazards.gpkg",
                           "hazards.dxf",
                           "clearances.csv",
                           "crossings.csv",
                           "fall_in.csv",
                           "summary.json",
                           "report.html"})
    paths.push_back((std::filesystem::path(folder) / name).string());
  return paths;
}

} // namespace linelet::powerline
