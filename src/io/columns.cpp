// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "columns.h"

#include <linelet/io/whole_shift.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "io/text_scan.h"

namespace linelet::io {

namespace {

/** Names without case, blanks and underscores, and their meaning. */
const std::map<std::string, std::string, std::less<>>&
aliases()
{
  static const std::map<std::string, std::string, std::less<>> table = {
      {"x", "x"},
      {"y", "y"},
      {"z", "z"},
      {"intensity", "intensity"},
      {"returnnumber", "return_number"},
      {"numberofreturns", "number_of_returns"},
      {"classification", "classification"},
      {"scanangle", "scan_angle"},
      {"scananglerank", "scan_angle"},
      {"userdata", "user_data"},
      {"pointsourceid", "point_source_id"},
      {"gpstime", "gps_time"},
      {"red", "red"},
      {"green", "green"},
      {"blue", "blue"},
      {"r", "red"},
      {"g", "green"},
      {"b", "blue"},
      {"diffusered", "red"},
      {"diffusegreen", "green"},
      {"diffuseblue", "blue"},
      {"nir", "nir"},
      {"infrared", "nir"},
      {"synthetic", "synthetic"},
      {"syntheticflag", "synthetic"},
      {"keypoint", "key_point"},
      {"keypointflag", "key_point"},
      {"withheld", "withheld"},
      {"withheldflag", "withheld"},
      {"overlap", "overlap"},
      {"overlapflag", "overlap"},
      {"scannerchannel", "scanner_channel"},
      {"scanchannel", "scanner_channel"},
      {"scandirection", "scan_direction"},
      {"scandirectionflag", "scan_direction"},
      {"edgeofflightline", "edge_of_flight_line"},
      {"edgeofflightlineflag", "edge_of_flight_line"},
      {"nx", "normal_x"},
      {"ny", "normal_y"},
      {"nz", "normal_z"},
      {"normalx", "normal_x"},
      {"normaly", "normal_y"},
      {"normalz", "normal_z"}};
  return table;
}

/** The meaning of \a name, or empty. */
std::string
knownName(const std::string& name)
{
  std::string key;
  for (char letter : name)
    if (letter != ' ' && letter != '_')
      key += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  if (key.rfind("scalar", 0) == 0) // CloudCompare's prefix for scalar fields in PLY
    key.erase(0, 6);
  const auto place = aliases().find(key);
  return place == aliases().end() ? std::string() : place->second;
}

Column*
findIn(std::vector<Column>& columns, std::string_view name)
{
  for (Column& column : columns)
    if (column.name == name)
      return &column;
  return nullptr;
}

/** Gives every column a unique name. */
void
makeNamesUnique(std::vector<Column>& columns)
{
  UniqueNames names;
  for (Column& column : columns)
    column.name = names.take(column.name.empty() ? "column" : column.name);
}

/** Splits rgb or rgba, packed into a float or an integer. */
void
unpackColors(std::vector<Column>& columns)
{
  for (const char* name : {"rgb", "rgba"}) {
    Column* packed = findIn(columns, name);
    if (packed == nullptr || sizeOf(typeOf(*packed)) != 4)
      continue;
    if (findIn(columns, "red") != nullptr || findIn(columns, "green") != nullptr ||
        findIn(columns, "blue") != nullptr)
      return;
    const std::size_t count = size(packed->values);
    std::array<std::vector<std::uint8_t>, 4> parts; // blue, green, red, alpha
    for (std::size_t part = 0; part < 4; ++part)
      parts[part].resize(count);
    std::visit(
        [&](const auto& values) {
          for (std::size_t i = 0; i < count; ++i) {
            std::uint32_t bits = 0;
            std::memcpy(&bits, &values[i], 4);
            for (std::size_t part = 0; part < 4; ++part)
              parts[part][i] = static_cast<std::uint8_t>(bits >> (8 * part));
          }
        },
        packed->values);
    packed->name = "red";
    packed->values = std::move(parts[2]);
    const bool alpha = std::string_view(name) == "rgba";
    columns.push_back({"green", std::move(parts[1]), {}});
    columns.push_back({"blue", std::move(parts[0]), {}});
    if (alpha)
      columns.push_back({"alpha", std::move(parts[3]), {}});
  }
}

/** Distance from \a value to the next float. */
double
floatGap(double value)
{
  const auto number = static_cast<float>(std::abs(value));
  return static_cast<double>(std::nextafter(number, INFINITY) - number);
}

} // namespace

std::vector<std::string>
canonicalNames(const std::vector<std::string>& names)
{
  std::vector<std::string> canonical;
  canonical.reserve(names.size());
  for (const std::string& name : names)
    canonical.push_back(cleanName(name));
  const std::set<std::string> taken(canonical.begin(), canonical.end());
  for (std::string& name : canonical) {
    const std::string known = knownName(name);
    if (!known.empty() && taken.count(known) == 0)
      name = known;
  }
  return canonical;
}

std::string
wordName(std::string_view name)
{
  std::string word = cleanName(name);
  for (char& letter : word)
    if (std::string_view(" ,;\"#").find(letter) != std::string_view::npos)
      letter = '_';
  return word.empty() ? "column" : word;
}

Cloud
cloudFromColumns(const Source& source, std::vector<Column> columns)
{
  Cloud cloud;
  double extent = 0, gap = 0; // the largest of all axes
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    const Column* column = findIn(columns, name);
    if (column == nullptr)
      source.fail("there is no '" + name + "' among its attributes" +
                  (columns.empty()
                       ? ""
                       : ", the first of which is '" + columns.front().name + "'"));
    cloud.points.resize(size(column->values));
    double low = INFINITY, high = -INFINITY;
    std::visit(
        [&](const auto& values) {
          for (std::size_t i = 0; i < values.size(); ++i) {
            const auto value = static_cast<double>(values[i]);
            cloud.points[i][axis] = value;
            if (std::isfinite(value)) {
              low = std::min(low, value);
              high = std::max(high, value);
            }
          }
        },
        column->values);
    cloud.shift[axis] = wholeShift(low, high);
    if (low <= high) {
      extent = std::max(extent, high - low);
      if (std::holds_alternative<std::vector<float>>(column->values))
        gap = std::max({gap, floatGap(low), floatGap(high)});
    }
    if (cloud.shift[axis] != 0)
      for (Point& point : cloud.points)
        point[axis] -= cloud.shift[axis];
    columns.erase(columns.begin() + (column - columns.data()));
  }
  constexpr double coarse = 1e-5; // of the extent: a millimeter in a hundred meters
  if (extent > 0 && gap > coarse * extent) {
    std::string apart;
    appendNumber(apart, gap);
    source.warn("coordinates are floats of 4 bytes, which lie " + apart +
                " apart this far from the origin: finer detail, if there was any, is "
                "lost; store them in 8 bytes, or minus a shift (linelet convert "
                "--shifted)");
  }
  unpackColors(columns);
  makeNamesUnique(columns);
  cloud.columns = std::move(columns);
  return cloud;
}

bool
isColor(std::string_view name)
{
  return name == "red" || name == "green" || name == "blue";
}

std::optional<std::array<std::vector<std::uint8_t>, 3>>
byteColors(const Cloud& cloud)
{
  std::array<std::vector<std::uint8_t>, 3> colors;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::array<const char*, 3> names = {"red", "green", "blue"};
    const Column* column = cloud.find(names[i]);
    if (column == nullptr)
      return {};
    if (const auto* bytes = std::get_if<std::vector<std::uint8_t>>(&column->values))
      colors[i] = *bytes;
    else if (const auto* words =
                 std::get_if<std::vector<std::uint16_t>>(&column->values))
      for (std::uint16_t word : *words) {
        if ((word & 0xFFU) != 0)
          return {};
        colors[i].push_back(static_cast<std::uint8_t>(word >> 8));
      }
    else
      return {};
  }
  const auto type = [&](const char* name) { return typeOf(*cloud.find(name)); };
  if (type("red") != type("green") || type("red") != type("blue"))
    return {};
  return colors;
}

void
appendValue(std::string& text, const Column& column, std::size_t i)
{
  std::visit([&](const auto& values) { appendNumber(text, values[i]); }, column.values);
}

} // namespace linelet::io
