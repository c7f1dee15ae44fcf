// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// The units of a file, from its WKT and from its GeoTIFF keys.

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <linelet/io/point_file.h>

#include "file_helpers.h"

using namespace linelet;
using namespace linelet::io;
using namespace linelet::test;

namespace {

constexpr double survey_foot = 1200.0 / 3937, foot = 0.3048;

template <class T>
std::string
raw(T value)
{
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

/** The units that the reader finds in a LAS 1.2 file with GeoTIFF keys. */
Units
unitsByKeys(const std::vector<std::pair<int, int>>& keys)
{
  const auto word = [](int value) { return raw(static_cast<std::uint16_t>(value)); };
  std::string directory =
      word(1) + word(1) + word(0) + word(static_cast<int>(keys.size()));
  for (const auto& [key, value] : keys)
    directory += word(key) + word(0) + word(1) + word(value);
  std::string record(54, '\0');
  record.replace(2, 15, "LASF_Projection");
  record.replace(18, 4, word(34735) + word(static_cast<int>(directory.size())));
  record += directory;
  std::string file(227, '\0');
  file.replace(0, 4, "LASF");
  file[24] = 1;
  file[25] = 2;
  file.replace(94, 2, word(227));
  file.replace(96, 8, raw(static_cast<std::uint32_t>(227 + record.size())) + raw(1U));
  file.replace(105, 6, word(20) + raw(1U));
  file.replace(111, 4, raw(1U));
  for (std::size_t at = 131; at < 155; at += 8)
    file.replace(at, 8, raw(0.01));
  const Folder folder;
  writeBytes(folder.file("a.las"), file + record + std::string(20, '\0'));
  return unitsOf(readCloud(folder.file("a.las")).wkt);
}

void
expectUnits(const Units& units, double plan, double height)
{
  EXPECT_NEAR(units.plan, plan, 1e-12) << units.plan_name;
  EXPECT_NEAR(units.height, height, 1e-12) << units.height_name;
}

constexpr int model = 1024, geographic = 2048, projected = 3072, projected_unit = 3076,
              vertical = 4096, vertical_unit = 4099, own = 32767;

} // namespace

TEST(Units, AreThoseOfTheTextPartByPart)
{
  const std::string meters = R"(LOCAL_CS["site",UNIT["metre",1]])",
                    feet = R"(LOCAL_CS["site",UNIT["US survey foot",)"
                           R"(0.304800609601219]])",
                    height = R"(VERT_CS["height",VERT_DATUM["sea",2005],)"
                             R"(UNIT["foot",0.3048]])";
  for (const std::string& unknown : {std::string(), std::string("nonsense"), meters})
    EXPECT_TRUE(unitsOf(unknown).areMeters()) << unknown;
  expectUnits(unitsOf(feet), survey_foot, survey_foot);
  EXPECT_EQ(unitsOf(feet).plan_name, "US survey foot");
  EXPECT_FALSE(unitsOf(feet).height_stated);
  const Units both = unitsOf("COMPD_CS[\"both\"," + meters + "," + height + "]");
  expectUnits(both, 1, foot);
  EXPECT_EQ(both.height_name, "foot");
  EXPECT_TRUE(both.height_stated);
  EXPECT_FALSE(both.areMeters());
}

TEST(Units, OfDegreesAndGeocentricCoordinatesAreNotLengths)
{
  const std::string degrees =
      R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],)"
      R"(PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]])";
  EXPECT_TRUE(std::isnan(unitsOf(degrees).plan));
  EXPECT_EQ(unitsOf(degrees).plan_name, "degree");
  const std::string geocentric =
      R"(GEOCCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],)"
      R"(PRIMEM["Greenwich",0],UNIT["metre",1]])";
  EXPECT_TRUE(std::isnan(unitsOf(geocentric).plan));
}

// EPSG:2263 New York Long Island (US survey feet), 6360 NAVD88 in US survey feet, 5703
// NAVD88 in meters, 26918 UTM zone 18 N.
TEST(Units, AreThoseOfTheSystemsThatKeysName)
{
  expectUnits(unitsByKeys({{model, 1}, {projected, 2263}}), survey_foot, survey_foot);
  expectUnits(
      unitsByKeys({{projected, 2263}, {vertical, 6360}}), survey_foot, survey_foot);
  expectUnits(unitsByKeys({{projected, 2263}, {vertical, 5703}}), survey_foot, 1);
  expectUnits(unitsByKeys({{projected, 26918}, {vertical, 5703}}), 1, 1);
  expectUnits(unitsByKeys({{projected, 26918}}), 1, 1);
}

TEST(Units, ThatKeysNameOverrideThoseOfTheSystem)
{
  expectUnits(unitsByKeys({{projected, 26918}, {projected_unit, 9002}}), foot, foot);
  expectUnits(unitsByKeys({{projected, 26918}, {vertical_unit, 9003}}), 1, survey_foot);
  expectUnits(unitsByKeys({{projected, 2263}, {vertical, 5703}, {vertical_unit, 9003}}),
              survey_foot,
              survey_foot);
  // Older files name 5103, the datum itself; PROJ has no such system.
  expectUnits(unitsByKeys({{projected, 2263}, {vertical, 5103}, {vertical_unit, 9001}}),
              survey_foot,
              1);
}

// A user-defined projection, as many counties have: its base is geographic, its
// coordinates are not.
TEST(Units, AreKnownOfASystemThatIsNot)
{
  expectUnits(
      unitsByKeys(
          {{model, 1}, {geographic, 4269}, {projected, own}, {projected_unit, 9003}}),
      survey_foot,
      survey_foot);
  expectUnits(
      unitsByKeys(
          {{model, 1}, {geographic, 4269}, {projected, own}, {projected_unit, 9001}}),
      1,
      1);
  EXPECT_TRUE(std::isnan(unitsByKeys({{model, 2}, {geographic, 4269}}).plan));
}
