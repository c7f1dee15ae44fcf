// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// The same scan in feet gives the same lines: attributes in meters, coordinates in
// feet.

#include <cmath>
#include <stdexcept>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include <linelet/io/point_file.h>
#include <linelet/powerline/extract_power_lines.h>
#include <linelet/powerline/metric_frame.h>
#include <linelet/powerline_output/output_files.h>

#include "test_data.h"

namespace linelet::powerline {
namespace {

constexpr double survey_foot = 1200.0 / 3937;

/** A cloud in survey feet, with heights in meters or in feet. */
io::Cloud
inFeet(io::Cloud cloud, bool metric_heights)
{
  const double height = metric_heights ? 1 : survey_foot;
  const Point unit(survey_foot, survey_foot, height);
  for (Point& p : cloud.points)
    p = p.cwiseQuotient(unit);
  cloud.shift = cloud.shift.cwiseQuotient(unit);
  const std::string plan = R"(LOCAL_CS["county",UNIT["US survey foot",)"
                           R"(0.3048006096012192]])";
  cloud.wkt = plan;
  if (metric_heights)
    cloud.wkt = "COMPD_CS[\"both\"," + plan +
                R"(,VERT_CS["height",VERT_DATUM["sea",2005],UNIT["metre",1]]])";
  return cloud;
}

std::vector<io::VectorLayer>
layersOf(const io::Cloud& cloud)
{
  return powerLineLayers(cloud, extractPowerLines(cloud), {});
}

void
expectSameInFeet(const std::vector<io::VectorLayer>& feet,
                 const std::vector<io::VectorLayer>& meters,
                 double height)
{
  const auto scaleOf = [&](const std::string& name) {
    return name == "lowest_x" || name == "lowest_y" ? survey_foot
           : name == "lowest_z" || name == "top_z"  ? height
                                                    : 1;
  };
  ASSERT_EQ(feet.size(), meters.size());
  for (std::size_t l = 0; l < feet.size(); ++l) {
    ASSERT_EQ(feet[l].features.size(), meters[l].features.size());
    // These scans are too coarse for jumpers and insulators.
    ASSERT_EQ(meters[l].features.empty(),
              meters[l].name == "jumpers" || meters[l].name == "insulators");
    for (std::size_t f = 0; f < feet[l].features.size(); ++f) {
      SCOPED_TRACE(meters[l].features[f].label);
      const io::VectorFeature& a = feet[l].features[f];
      const io::VectorFeature& b = meters[l].features[f];
      ASSERT_EQ(a.vertices.size(), b.vertices.size());
      const Point unit(survey_foot, survey_foot, height);
      for (std::size_t v = 0; v < a.vertices.size(); ++v)
        EXPECT_LT((a.vertices[v].cwiseProduct(unit) - b.vertices[v]).norm(), 1e-3);
      for (std::size_t k = 0; k < a.attributes.size(); ++k) {
        const auto& [name, value] = a.attributes[k];
        const auto* number = std::get_if<double>(&value);
        if (number == nullptr) {
          EXPECT_EQ(value, b.attributes[k].second) << name;
          continue;
        }
        const double expected = std::get<double>(b.attributes[k].second);
        if (std::isnan(expected))
          EXPECT_TRUE(std::isnan(*number)) << name;
        else
          EXPECT_NEAR(*number * scaleOf(name), expected, 1e-3) << name;
      }
    }
  }
}

class Feet : public ::testing::TestWithParam<const char*> {
protected:
  io::Cloud
  read() const
  {
    const std::string name = GetParam();
    return io::readCloud(name == "corridor.las"
                             ? std::string(LINELET_SOURCE_DIR) + "/data/corridor.las"
                             : test::dataPath(name).string());
  }
};

TEST_P(Feet, GiveTheLinesOfTheSameScanInMeters)
{
  if (std::string(GetParam()) != "corridor.las")
    LINELET_NEEDS_DATA(GetParam());
  const io::Cloud scan = read();
  for (const bool metric_heights : {false, true}) {
    const io::Cloud feet = inFeet(scan, metric_heights);
    // Exactly the conversion to meters: rounding alone moves points in and out of the
    // tubes of wires.
    io::Cloud meters = scan;
    const MetricFrame frame(feet);
    for (std::size_t i = 0; i < feet.points.size(); ++i)
      meters.points[i] = frame.meters(feet.points[i]);
    expectSameInFeet(
        layersOf(feet), layersOf(meters), metric_heights ? 1 : survey_foot);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scans, Feet, ::testing::Values("corridor.las", "lidar/ahn4_12BZ1_21_thin8.las"));

TEST(FeetInOutputs, AreNamedBesideCoordinates)
{
  io::Cloud cloud;
  cloud.shift = Point(1e6, 2e5, 300);
  cloud.points = {{0, 0, 0}};
  cloud = inFeet(cloud, true);
  PowerLineNetwork none;
  none.classes = {0};
  none.wire_id = none.span_id = {0};
  none.wire_distance = {NAN};
  const std::string report = powerLineReport(cloud, none, {});
  EXPECT_NE(report.find("x and y in US survey foot, z in metre"), std::string::npos);
  const std::string summary = powerLineSummary(cloud, none, {});
  EXPECT_NE(summary.find("\"coordinates\": \"US survey foot\""), std::string::npos);
  EXPECT_NE(summary.find("\"lengths\": \"metre\""), std::string::npos);
}

TEST(Degrees, AreRefused)
{
  io::Cloud cloud;
  cloud.points = {{0, 0, 0}};
  cloud.wkt =
      R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],)"
      R"(PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]])";
  EXPECT_THROW(extractPowerLines(cloud), std::invalid_argument);
}

} // namespace
} // namespace linelet::powerline
