// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <optional>
#include <unordered_set>

#include <linelet/io/las_summary.h>
#include <linelet/io/usable_points.h>
#include <linelet/search/scale_unit.h>

#include "cloud_files.h"
#include "commands.h"
#include "frame.h"

namespace linelet::apps {

namespace {

using nlohmann::ordered_json;

struct Bounds {
  Point low = Point::Constant(std::numeric_limits<double>::infinity());
  Point high = -low;
};

Bounds
boundsOf(const Points& points)
{
  Bounds bounds;
  for (const Point& point : points)
    if (point.allFinite()) {
      bounds.low = bounds.low.cwiseMin(point);
      bounds.high = bounds.high.cwiseMax(point);
    }
  return bounds;
}

/** Points per unit of area in plan, counting only cells of side \a side that hold
 * points, so that gaps in the survey do not matter. */
double
densityOf(const Points& points, const Bounds& bounds, double side)
{
  const Point extent = (bounds.high - bounds.low) / side;
  if (!(side > 0) || !(extent.head<2>().maxCoeff() < 1e9))
    return std::numeric_limits<double>::quiet_NaN();
  std::unordered_set<std::uint64_t> cells;
  std::size_t count = 0;
  for (const Point& point : points) {
    if (!point.allFinite())
      continue;
    const Point cell = (point - bounds.low) / side;
    cells.insert(static_cast<std::uint64_t>(cell.x()) << 32 |
                 static_cast<std::uint64_t>(cell.y()));
    ++count;
  }
  return static_cast<double>(count) / (static_cast<double>(cells.size()) * side * side);
}

/** The ASPRS names of the classes. */
std::string
className(int number)
{
  static const std::array<const char*, 23> names = {"never classified",
                                                    "unassigned",
                                                    "ground",
                                                    "low vegetation",
                                                    "medium vegetation",
                                                    "high vegetation",
                                                    "building",
                                                    "low noise",
                                                    "model key point",
                                                    "water",
                                                    "rail",
                                                    "road",
                                                    "overlap",
                                                    "wire guard",
                                                    "wire conductor",
                                                    "tower",
                                                    "wire connector",
                                                    "bridge deck",
                                                    "high noise",
                                                    "overhead structure",
                                                    "ignored ground",
                                                    "snow",
                                                    "temporal exclusion"};
  if (number >= 0 && number < static_cast<int>(names.size()))
    return names[static_cast<std::size_t>(number)];
  return number < 64 ? "reserved" : "user's own";
}

ordered_json
classesOf(const io::Cloud& cloud)
{
  std::map<int, std::size_t> counts;
  if (const io::Column* column = cloud.find("classification"))
    for (std::size_t i = 0; i < cloud.points.size(); ++i)
      ++counts[static_cast<int>(io::valueAt(*column, i))];
  ordered_json classes = ordered_json::array();
  for (const auto& [number, count] : counts)
    classes.push_back(
        {{"class", number}, {"name", className(number)}, {"points", count}});
  return classes;
}

/** Number of points with each flag that the file has. */
ordered_json
flagsOf(const io::Cloud& cloud)
{
  ordered_json flags = ordered_json::object();
  for (const char* name : {"withheld", "overlap", "synthetic", "key_point"})
    if (const io::Column* column = cloud.find(name)) {
      std::size_t count = 0;
      for (std::size_t i = 0; i < cloud.points.size(); ++i)
        count += io::valueAt(*column, i) != 0 ? 1 : 0;
      flags[name] = count;
    }
  return flags;
}

ordered_json
attributesOf(const io::Cloud& cloud)
{
  ordered_json attributes = ordered_json::array();
  for (const io::Column& column : cloud.columns) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
      const double value = io::valueAt(column, i);
      low = std::min(low, value); // NaN compares false
      high = std::max(high, value);
    }
    ordered_json attribute = {{"name", column.name},
                              {"type", io::typeName(column.values)}};
    attribute["minimum"] = low <= high ? ordered_json(low) : ordered_json();
    attribute["maximum"] = low <= high ? ordered_json(high) : ordered_json();
    if (!column.description.empty())
      attribute["description"] = column.description;
    attributes.push_back(attribute);
  }
  return attributes;
}

ordered_json
numberOrNull(double value)
{
  return std::isfinite(value) ? ordered_json(value) : ordered_json();
}

ordered_json
describe(const std::string& path,
         const io::Cloud& cloud,
         const io::UsablePoints& usable,
         unsigned threads)
{
  ordered_json out;
  out["file"] = path;
  out["format"] = cloud.format;
  out["points"] = cloud.points.size();
  const Bounds bounds = boundsOf(cloud.points);
  const bool any = bounds.low.x() <= bounds.high.x();
  for (const auto& [name, corner] :
       {std::pair("minimum", bounds.low), std::pair("maximum", bounds.high)}) {
    const Point world = cloud.shift + corner;
    out["bounds"][name] =
        any ? ordered_json({world.x(), world.y(), world.z()}) : ordered_json();
  }
  out["reference_system"] = io::referenceName(cloud.wkt);
  const double unit = scaleUnit(usable.points(), 1024, 1, threads);
  const double density = any ? densityOf(usable.points(), bounds, 5 * unit) : NAN;
  out["scale_unit"] = numberOrNull(unit);
  out["density"] = numberOrNull(density);
  out["spacing"] = numberOrNull(1 / std::sqrt(density));
  out["flags"] = flagsOf(cloud);
  out["classes"] = classesOf(cloud);
  out["attributes"] = attributesOf(cloud);
  return out;
}

void
printNumber(const char* label, const ordered_json& value, const char* meaning)
{
  if (value.is_null())
    std::printf("%-17s unknown\n", label);
  else
    std::printf("%-17s %.4g %s\n", label, value.get<double>(), meaning);
}

void
print(const ordered_json& info)
{
  const auto text = [&](const char* key) { return info[key].get<std::string>(); };
  std::printf("%-17s %s\n", "file", text("file").c_str());
  std::printf("%-17s %s\n", "format", text("format").c_str());
  std::printf("%-17s %zu\n", "points", info["points"].get<std::size_t>());
  const std::string system = text("reference_system");
  std::printf(
      "%-17s %s\n", "reference system", system.empty() ? "unknown" : system.c_str());
  for (int axis = 0; axis < 3 && !info["bounds"]["minimum"].is_null(); ++axis)
    std::printf(
        "%-17s %.6f to %.6f\n",
        std::string(1, "xyz"[axis]).c_str(),
        info["bounds"]["minimum"][static_cast<std::size_t>(axis)].get<double>(),
        info["bounds"]["maximum"][static_cast<std::size_t>(axis)].get<double>());
  printNumber(
      "scale unit D", info["scale_unit"], "(median distance to the 6th neighbor)");
  printNumber("density", info["density"], "points per square unit");
  printNumber("spacing", info["spacing"], "units, of the ground plan");
  for (const auto& [name, count] : info["flags"].items())
    if (count > 0)
      std::printf("%-17s %10zu  %s\n",
                  name.c_str(),
                  count.get<std::size_t>(),
                  name == "withheld" ? "flagged; left out of every analysis"
                                     : "flagged; used like other points");
  for (const auto& entry : info["classes"])
    std::printf("class %-11d %10zu  %s\n",
                entry["class"].get<int>(),
                entry["points"].get<std::size_t>(),
                entry["name"].get<std::string>().c_str());
  for (const auto& attribute : info["attributes"]) {
    std::printf("attribute         %-22s %-8s",
                attribute["name"].get<std::string>().c_str(),
                attribute["type"].get<std::string>().c_str());
    if (!attribute["minimum"].is_null())
      std::printf(" %.10g to %.10g",
                  attribute["minimum"].get<double>(),
                  attribute["maximum"].get<double>());
    std::printf("\n");
  }
}

/** One line per file from its header, and their sum. */
ordered_json
printTable(CloudInput& input)
{
  ordered_json files = ordered_json::array();
  std::size_t points = 0;
  Point low = Point::Constant(std::numeric_limits<double>::infinity()), high = -low;
  std::printf("%12s %14s %14s %14s %14s  %-28s %s\n",
              "points",
              "x from",
              "x to",
              "y from",
              "y to",
              "format",
              "file");
  const auto line = [](std::size_t count,
                       const Point& from,
                       const Point& to,
                       const std::string& format,
                       const std::string& name) {
    std::printf("%12zu %14.2f %14.2f %14.2f %14.2f  %-28s %s\n",
                count,
                from.x(),
                to.x(),
                from.y(),
                to.y(),
                format.c_str(),
                name.c_str());
  };
  for (const io::FileSummary& file : input.headers()) {
    line(file.points, file.low, file.high, file.format, file.path);
    files.push_back({{"file", file.path},
                     {"format", file.format},
                     {"points", file.points},
                     {"minimum", {file.low.x(), file.low.y(), file.low.z()}},
                     {"maximum", {file.high.x(), file.high.y(), file.high.z()}},
                     {"reference_system", io::referenceName(file.wkt)}});
    points += file.points;
    if (file.points > 0) {
      low = low.cwiseMin(file.low);
      high = high.cwiseMax(file.high);
    }
  }
  if (points > 0)
    line(points, low, high, std::to_string(files.size()) + " files", "in all");
  return {{"points", points}, {"files", files}};
}

/** Describes what only LAS files have. */
void
describeLas(ordered_json& out, const io::Cloud& cloud)
{
  const std::optional<io::LasSummary> las = io::lasSummary(cloud);
  if (!las)
    return;
  const auto numbers = [](const Point& p) { return ordered_json{p.x(), p.y(), p.z()}; };
  out["scale"] = numbers(las->scale);
  out["offset"] = numbers(las->offset);
  out["copc_levels"] = las->copc_levels;
  out["epsg"] = las->epsg;
  out["records"] = las->records;
  std::map<int, std::size_t> returns;
  if (const io::Column* column = cloud.find("return_number"))
    for (std::size_t i = 0; i < cloud.points.size(); ++i)
      ++returns[static_cast<int>(io::valueAt(*column, i))];
  out["returns"] = ordered_json::object();
  for (const auto& [number, count] : returns)
    out["returns"][std::to_string(number)] = count;
}

void
printLas(const ordered_json& info)
{
  if (!info.contains("scale"))
    return;
  const auto triple = [&info](const char* key) {
    std::printf("%-17s %.10g %.10g %.10g\n",
                key,
                info[key][0].get<double>(),
                info[key][1].get<double>(),
                info[key][2].get<double>());
  };
  if (info["copc_levels"] > 0)
    std::printf("%-17s octree of %d levels\n", "COPC", info["copc_levels"].get<int>());
  if (info["epsg"] > 0)
    std::printf("%-17s %d\n", "EPSG", info["epsg"].get<int>());
  triple("scale");
  triple("offset");
  for (const auto& [number, count] : info["returns"].items())
    std::printf("return %-10s %10zu\n", number.c_str(), count.get<std::size_t>());
  for (const auto& record : info["records"])
    std::printf("%-17s %s\n", "record", record.get<std::string>().c_str());
}

} // namespace

int
runInfo(const std::vector<std::string>& arguments)
{
  Frame frame(
      "info",
      "Shows what a point file holds: extent, density, flags, classes and attributes. "
      "Scale unit and density are those of the points that are neither withheld nor "
      "noise. For several files, prints a table of their headers.");
  CloudInput input(frame);
  frame.parse(arguments);

  if (input.files().size() > 1) {
    frame.summary = printTable(input);
    return frame.finish();
  }
  const io::Cloud cloud = input.read();
  frame.summary = describe(input.path(), cloud, input.usable(cloud), frame.threads);
  describeLas(frame.summary, cloud);
  print(frame.summary);
  printLas(frame.summary);
  return frame.finish();
}

} // namespace linelet::apps
