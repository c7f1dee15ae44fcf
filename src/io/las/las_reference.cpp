// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "las_reference.h"

#include <map>

#include "io/reference_systems.h"
#include "las_header.h"

namespace linelet::io {

namespace {

const LasRecord*
findRecord(const LasOrigin& origin, std::string_view user, unsigned number)
{
  for (const auto* records : {&origin.records, &origin.extended})
    for (const LasRecord& record : *records)
      if (record.is(user, number) && !record.data.empty())
        return &record;
  return nullptr;
}

/** The WKT of a record, or empty if it cannot be understood. */
std::string
wktIn(const LasRecord* record)
{
  if (record == nullptr)
    return {};
  const std::string wkt = record->data.substr(0, record->data.find('\0'));
  const ReferenceSystems* systems = referenceSystems();
  return systems == nullptr || systems->isUnderstood(wkt) ? wkt : std::string();
}

/** GeoTIFF keys with inline values: key -> number. */
std::map<unsigned, unsigned>
geoKeys(const std::string& data)
{
  std::map<unsigned, unsigned> keys;
  for (std::size_t at = 8; at + 8 <= data.size(); at += 8) {
    const auto word = [&](std::size_t i) {
      return load<std::uint16_t>(data.data() + at + 2 * i);
    };
    if (word(1) == 0)
      keys[word(0)] = word(3);
  }
  return keys;
}

/** The codes of a reference system among the GeoTIFF keys. */
ReferenceCodes
codesIn(const LasRecord& record)
{
  constexpr unsigned model = 1024, geographic = 2048, projected = 3072,
                     projected_unit = 3076, vertical = 4096, vertical_unit = 4099,
                     user_defined = 32767;
  const auto keys = geoKeys(record.data);
  const auto codeOf = [&](unsigned key) {
    const auto place = keys.find(key);
    const bool usable = place != keys.end() && place->second != user_defined;
    return usable ? static_cast<int>(place->second) : 0;
  };
  ReferenceCodes codes;
  codes.plan = codeOf(projected);
  // A user-defined projection names its geographic base, which is not its system.
  if (codes.plan == 0 && codeOf(model) != 1)
    codes.plan = codeOf(geographic);
  codes.height = codeOf(vertical);
  codes.plan_unit = codeOf(projected_unit);
  codes.height_unit = codeOf(vertical_unit);
  return codes;
}

} // namespace

std::string
lasReferenceSystem(const LasOrigin& origin, std::string& problem)
{
  const LasRecord* wkt = findRecord(origin, "LASF_Projection", 2112);
  const LasRecord* keys = findRecord(origin, "LASF_Projection", 34735);
  const unsigned encoding =
      load<std::uint16_t>(origin.header.data() + las_at::global_encoding);
  const bool wkt_first = (encoding & las_wkt_bit) != 0 || origin.format >= 6;

  const ReferenceCodes codes = keys != nullptr ? codesIn(*keys) : ReferenceCodes();
  std::string text = wkt_first ? wktIn(wkt) : std::string();
  const ReferenceSystems* systems = referenceSystems();
  if (text.empty() && systems != nullptr)
    text = systems->wktOfCodes(codes);
  if (text.empty())
    text = wktIn(wkt);
  if (text.empty())
    text = wktIn(findRecord(origin, "liblas", 2112)); // from before LAS defined one
  if (!text.empty())
    return text;
  if (codes.plan != 0 && systems == nullptr)
    problem = "reference system EPSG:" + std::to_string(codes.plan) +
              " of the GeoTIFF keys needs PROJ's tables, and this program was linked "
              "without linelet::vector";
  else if (codes.plan != 0)
    problem = "reference system EPSG:" + std::to_string(codes.plan) +
              " of the GeoTIFF keys is not in PROJ's tables";
  else if (keys != nullptr)
    problem = "the GeoTIFF keys name no EPSG code";
  else if (wkt != nullptr)
    problem = "the WKT record cannot be understood";
  if (!problem.empty())
    problem += "; the reference system is treated as unknown";
  return systems != nullptr ? systems->wktOfUnit(codes.plan_unit) : std::string();
}

} // namespace linelet::io
