// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/virtual_cloud.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include <nlohmann/json.hpp>

#include <linelet/io/output_file.h>

#include "reference.h"

namespace linelet::io {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/** Ring of corners of the extent of \a file in plan, in longitude and latitude. */
ordered_json
ringOf(const FileSummary& file, std::array<double, 4>& box)
{
  const double x[] = {file.low.x(), file.high.x(), file.high.x(), file.low.x()};
  const double y[] = {file.low.y(), file.low.y(), file.high.y(), file.high.y()};
  Points corners;
  for (int i = 0; i < 4; ++i)
    corners.push_back({x[i], y[i], 0});
  if (!toLongitudeLatitude(corners, file.wkt))
    return nullptr;
  box = {corners[0].x(), corners[0].y(), corners[0].x(), corners[0].y()};
  ordered_json ring = ordered_json::array();
  for (const int i : {0, 1, 2, 3, 0}) {
    const Point& p = corners[static_cast<std::size_t>(i)];
    ring.push_back({p.x(), p.y()});
    box = {std::min(box[0], p.x()),
           std::min(box[1], p.y()),
           std::max(box[2], p.x()),
           std::max(box[3], p.y())};
  }
  return ring;
}

ordered_json
featureOf(const FileSummary& file,
          const fs::path& folder,
          std::vector<std::string>* warnings)
{
  ordered_json feature = {
      {"type", "Feature"},
      {"stac_version", "1.0.0"},
      {"stac_extensions",
       {"https://stac-extensions.github.io/pointcloud/v1.0.0/schema.json",
        "https://stac-extensions.github.io/projection/v1.1.0/schema.json"}},
      {"id", fs::path(file.path).stem().string()}};
  std::array<double, 4> box{};
  const ordered_json ring = ringOf(file, box);
  feature["geometry"] =
      ring.is_null() ? ordered_json()
                     : ordered_json({{"type", "Polygon"}, {"coordinates", {ring}}});
  if (!ring.is_null())
    feature["bbox"] = {box[0], box[1], file.low.z(), box[2], box[3], file.high.z()};
  else if (warnings != nullptr)
    warnings->push_back(file.path + ": its reference system and place on Earth are "
                                    "unknown; it gets no geometry");
  ordered_json& properties = feature["properties"];
  properties["datetime"] = "1970-01-01T00:00:00Z"; // required by STAC, but unknown
  properties["pc:count"] = file.points;
  properties["pc:type"] = "lidar";
  properties["pc:encoding"] = fs::path(file.path).extension().string().substr(1);
  properties["proj:bbox"] = {file.low.x(),
                             file.low.y(),
                             file.low.z(),
                             file.high.x(),
                             file.high.y(),
                             file.high.z()};
  if (!file.wkt.empty())
    properties["proj:wkt2"] = wkt2Of(file.wkt);
  const fs::path place = fs::absolute(file.path).lexically_relative(folder);
  feature["assets"]["data"] = {{"href", "./" + place.generic_string()},
                               {"roles", {"data"}}};
  feature["links"] = ordered_json::array();
  return feature;
}

} // namespace

void
writeVirtualCloud(const std::string& path,
                  const std::vector<FileSummary>& files,
                  std::vector<std::string>* warnings)
{
  const fs::path folder = fs::absolute(path).lexically_normal().parent_path();
  ordered_json all = {{"type", "FeatureCollection"}};
  all["features"] = ordered_json::array();
  for (const FileSummary& file : files)
    all["features"].push_back(featureOf(file, folder, warnings));
  OutputFile out(path);
  out.write(all.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n');
  out.commit();
}

} // namespace linelet::io
