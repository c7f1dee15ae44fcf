// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <gmock/gmock.h>

#include <linelet/features/tensor_estimation.h>
#include <linelet/io/point_file.h>
#include <linelet/search/scale_unit.h>

#include "run_tool.h"

using namespace linelet;

namespace {

using linelet::test::Outcome;
using linelet::test::ToolTest;
using testing::HasSubstr;

class TensorCommand : public ToolTest {
protected:
  Outcome
  tensor(const std::string& arguments) const
  {
    return run("tensor " + arguments);
  }

  /** \brief A wire over ground in UTM coordinates, each point with a class and a
   * size. */
  void
  writeScene(const std::string& file) const
  {
    boost::random::mt19937 random(1);
    boost::random::normal_distribution<double> normal;
    io::Cloud cloud;
    cloud.shift = Point(512000, 5427000, 200);
    std::vector<std::uint8_t> classes;
    std::vector<float> sizes;
    for (int i = 0; i < 400; ++i) {
      const double a = normal(random), b = normal(random), c = normal(random);
      cloud.points.push_back(i % 2 == 0 ? Point(5 * a, 0.03 * b, 9 + 0.03 * c)
                                        : Point(5 * a, 5 * b, 0.1 * c));
      classes.push_back(i % 2 == 0 ? 14 : 2);
      sizes.push_back(1.0f + 0.25f * static_cast<float>(i % 4));
    }
    cloud.set({"classification", classes, ""});
    cloud.set({"size", sizes, ""});
    io::writeCloud(file, cloud);
  }
};

void
expectRecords(const io::Cloud& written,
              const std::vector<PointDistributionTensor>& records)
{
  ASSERT_EQ(written.points.size(), records.size());
  for (const char* name :
       {"xx", "lambda1", "major_x", "normal_z", "sphericity", "neighbors"})
    ASSERT_NE(written.find(name), nullptr) << name;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const auto at = [&](const char* name) {
      return io::valueAt(*written.find(name), i);
    };
    EXPECT_EQ(at("neighbors"), records[i].neighbors);
    ASSERT_EQ(std::isnan(at("linearity")), std::isnan(records[i].linearity));
    if (std::isnan(records[i].linearity))
      continue;
    EXPECT_NEAR(at("linearity"), records[i].linearity, 1e-6);
    EXPECT_NEAR(at("lambda3"), records[i].lambda3, 1e-5);
    EXPECT_NEAR(at("yz"), records[i].yz, 1e-5);
  }
}

} // namespace

TEST_F(TensorCommand, AddsTheRecordToTheAttributesInEveryFormat)
{
  for (const std::string ending : {"las", "pcd", "ply", "csv"}) {
    SCOPED_TRACE(ending);
    const std::string input = path("in." + ending), output = path("out." + ending);
    writeScene(input);
    const Outcome run = tensor(input + " " + output + " --radius 1.5 --centroid mean");
    ASSERT_EQ(run.code, 0) << run.error;
    EXPECT_THAT(run.out, HasSubstr("400 points, radius 1.5"));

    const io::Cloud before = io::readCloud(input), after = io::readCloud(output);
    TensorSettings settings;
    settings.radius = 1.5;
    settings.centroid = Centroid::Mean;
    expectRecords(after, estimateTensors(before.points, before.points, settings));
    ASSERT_NE(after.find("size"), nullptr);
    for (std::size_t i = 0; i < before.points.size(); ++i) {
      EXPECT_EQ(before.shift + before.points[i], after.shift + after.points[i]);
      for (const char* name : {"classification", "size"})
        EXPECT_EQ(io::valueAt(*before.find(name), i),
                  io::valueAt(*after.find(name), i));
    }
  }
}

TEST_F(TensorCommand, TakesSizesFromFieldsAndCounts)
{
  const std::string input = path("in.ply"), output = path("out.ply");
  writeScene(input);
  const io::Cloud cloud = io::readCloud(input);
  NeighborhoodSizes radii, counts;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    radii.radii.push_back(io::valueAt(*cloud.find("size"), i));
    counts.counts.push_back(cloud.find("classification") == nullptr ? 0
                            : i % 2 == 0                            ? 14
                                                                    : 2);
  }
  ASSERT_EQ(tensor(input + " " + output + " --radius-field size").code, 0);
  expectRecords(io::readCloud(output),
                estimateTensors(cloud.points, cloud.points, {}, radii));
  ASSERT_EQ(tensor(input + " " + output + " --knn-field classification").code, 0);
  expectRecords(io::readCloud(output),
                estimateTensors(cloud.points, cloud.points, {}, counts));
  ASSERT_EQ(tensor(input + " " + output + " --knn 9 --weight step:0.5").code, 0);
  TensorSettings nine;
  nine.k = 9;
  nine.weighting = "step:0.5";
  expectRecords(io::readCloud(output),
                estimateTensors(cloud.points, cloud.points, nine));
}

TEST_F(TensorCommand, EverySearchGivesTheSame)
{
  const std::string input = path("in.las"), output = path("out.las");
  writeScene(input);
  const io::Cloud cloud = io::readCloud(input);
  for (const char* size : {" --radius 1.5", " --knn 9", " --radius-field size"}) {
    TensorSettings settings;
    NeighborhoodSizes sizes;
    if (size == std::string(" --knn 9"))
      settings.k = 9;
    else if (size == std::string(" --radius 1.5"))
      settings.radius = 1.5;
    else
      for (std::size_t i = 0; i < cloud.points.size(); ++i)
        sizes.radii.push_back(io::valueAt(*cloud.find("size"), i));
    const auto expected = estimateTensors(cloud.points, cloud.points, settings, sizes);
    for (const std::string search : {"flann", "octree", "builtin", "grid"}) {
      SCOPED_TRACE(search + size);
      const Outcome run = tensor(input + " " + output + size + " --search " + search +
                                 " --json " + path("summary.json"));
      ASSERT_EQ(run.code, 0) << run.error;
      expectRecords(io::readCloud(output), expected);
      EXPECT_EQ(json(path("summary.json"))["engine"],
                search == "builtin" ? "tree" : search);
    }
  }
  const Outcome both =
      tensor(input + " " + output + " --radius 1 --search octree --engine grid");
  EXPECT_EQ(both.code, 1);
  EXPECT_THAT(both.error, HasSubstr("give only one"));
}

TEST_F(TensorCommand, ChoosesARadiusAndReportsIt)
{
  const std::string input = path("in.csv"), output = path("out.csv");
  writeScene(input);
  const double unit = scaleUnit(io::readCloud(input).points);
  Outcome run = tensor(input + " " + output + " --json " + path("summary.json"));
  ASSERT_EQ(run.code, 0) << run.error;
  auto summary = json(path("summary.json"));
  EXPECT_DOUBLE_EQ(summary["radius"], 3 * unit);
  EXPECT_DOUBLE_EQ(summary["scale_unit"], unit);
  EXPECT_EQ(summary["points"], 400);
  EXPECT_EQ(summary["engine"], "grid");
  EXPECT_EQ(summary["weight"], "fermi-dirac-1");
  EXPECT_GE(summary["seconds"]["tensor"], 0);

  // Too small a radius isolates points, so a better one is suggested.
  run = tensor(input + " " + output + " --radius 0.001 --json " + path("summary.json"));
  ASSERT_EQ(run.code, 0) << run.error;
  summary = json(path("summary.json"));
  EXPECT_EQ(summary["unknown"], 400);
  EXPECT_THAT(run.out, HasSubstr("400 points have no shape"));
  EXPECT_THAT(run.out, HasSubstr("try --radius"));
}

TEST_F(TensorCommand, ReportsErrorsInOneLine)
{
  const std::string input = path("in.csv"), files = input + " " + path("out.csv");
  writeScene(input);
  const std::vector<std::pair<std::string, std::string>> failures = {
      {files + " --radius -1", "radius -1 is not a positive finite number"},
      {files + " --radius 1 --knn 5", "more than one size"},
      {files + " --radius-field width", "there is no field 'width'"},
      {path("none.las") + " " + path("out.las"), "none.las"},
  };
  for (const auto& [arguments, expected] : failures) {
    const Outcome run = tensor(arguments);
    EXPECT_EQ(run.code, 1) << arguments;
    EXPECT_THAT(run.error, HasSubstr(expected));
    EXPECT_EQ(lines(run.error), 1) << run.error;
  }
  for (const char* usage :
       {" --weight gauss", " --centroid center", " --engine fast", " --knn x"})
    EXPECT_EQ(tensor(files + usage).code, 2) << usage;
  EXPECT_EQ(tensor("").code, 2);
  EXPECT_EQ(tensor("--help").code, 0);
}
