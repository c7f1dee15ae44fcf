// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "las_compatible.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace linelet::io {

namespace {

// Names of the extra entries.
constexpr std::string_view angle = "LAS 1.4 scan angle",
                           returns = "LAS 1.4 extended returns",
                           classes = "LAS 1.4 classification",
                           flags = "LAS 1.4 flags and channel",
                           infrared = "LAS 1.4 NIR band";
constexpr std::array<std::string_view, 5> entries = {
    angle, returns, classes, flags, infrared};

using Bytes = std::vector<std::uint8_t>;

/** Whether \a record marks a file as being in this mode. */
bool
isMark(const LasRecord& record)
{
  return record.is("lascompatible", 22204);
}

/** The bytes of the column \a name, or null if its values are not bytes. */
Bytes*
bytesOf(Cloud& cloud, std::string_view name)
{
  Column* column = cloud.find(name);
  return column != nullptr ? std::get_if<Bytes>(&column->values) : nullptr;
}

/** The format that a cloud in format 0 to 5 stands for. */
int
formatOf(const Cloud& cloud, bool waveform)
{
  if (waveform)
    return cloud.find("red") != nullptr ? 10 : 9;
  if (cloud.find("red") == nullptr)
    return 6;
  return cloud.find(infrared) != nullptr ? 8 : 7;
}

/** Whole degrees and the remaining steps, combined into steps of 0.006 degrees. */
std::vector<float>
angles(const std::vector<std::int8_t>& degrees, const Column& rest)
{
  std::vector<float> angles(degrees.size());
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double steps =
        std::round(static_cast<double>(static_cast<float>(degrees[i]) / 0.006F)) +
        std::round(valueAt(rest, i) / las_angle_step);
    angles[i] = static_cast<float>(steps * las_angle_step);
  }
  return angles;
}

} // namespace

bool
isCompatible(const LasOrigin& origin)
{
  return origin.format <= 5 &&
         std::any_of(origin.records.begin(), origin.records.end(), isMark);
}

int
restoreCompatible(Cloud& cloud, LasOrigin& origin)
{
  Column* degrees = cloud.find("scan_angle");
  const Column* rest = cloud.find(angle);
  Bytes *more_returns = bytesOf(cloud, returns),
        *more_classes = bytesOf(cloud, classes), *bits = bytesOf(cloud, flags);
  Bytes *number = bytesOf(cloud, "return_number"),
        *count = bytesOf(cloud, "number_of_returns"),
        *classification = bytesOf(cloud, "classification");
  if (!isCompatible(origin) || degrees == nullptr || rest == nullptr ||
      more_returns == nullptr || more_classes == nullptr || bits == nullptr ||
      !std::holds_alternative<std::vector<std::int8_t>>(degrees->values))
    return 0;
  const int format = formatOf(cloud, hasWaveform(origin.format));
  const std::size_t size = cloud.points.size();
  Bytes overlap(size), channel(size);
  for (std::size_t i = 0; i < size; ++i) {
    const auto sum = [](std::uint8_t a, unsigned b) {
      return static_cast<std::uint8_t>(a + b);
    };
    (*number)[i] = sum((*number)[i], (*more_returns)[i] >> 4U);
    (*count)[i] = sum((*count)[i], (*more_returns)[i] & 15U);
    (*classification)[i] = sum((*classification)[i], (*more_classes)[i]);
    overlap[i] = (*bits)[i] & 1U;
    channel[i] = static_cast<std::uint8_t>((*bits)[i] >> 1U & 3U);
  }
  degrees->values = angles(std::get<std::vector<std::int8_t>>(degrees->values), *rest);
  if (const Column* nir = cloud.find(infrared))
    cloud.set({"nir", nir->values, {}});
  cloud.set({"overlap", std::move(overlap), {}});
  cloud.set({"scanner_channel", std::move(channel), {}});

  const auto isEntry = [](const std::string& name) {
    return std::find(entries.begin(), entries.end(), name) != entries.end();
  };
  auto& columns = cloud.columns;
  columns.erase(
      std::remove_if(columns.begin(),
                     columns.end(),
                     [&](const Column& column) { return isEntry(column.name); }),
      columns.end());
  auto& extras = origin.extras;
  extras.erase(std::remove_if(extras.begin(),
                              extras.end(),
                              [&](const LasExtra& extra) {
                                return extra.columns.size() == 1 &&
                                       isEntry(extra.columns.front());
                              }),
               extras.end());
  origin.records.erase(
      std::find_if(origin.records.begin(), origin.records.end(), isMark));
  std::string described;
  for (const LasExtra& extra : extras)
    described += extra.descriptor;
  const auto isDescription = [](const LasRecord& r) { return r.is("LASF_Spec", 4); };
  auto& records = origin.records;
  records.erase(std::remove_if(records.begin(), records.end(), isDescription),
                records.end());
  if (!described.empty())
    records.push_back(makeLasRecord("LASF_Spec", 4, "", std::move(described)));
  return format;
}

} // namespace linelet::io
