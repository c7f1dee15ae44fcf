// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Tiles of a cloud in one call, compared with the cloud in one file.

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <gmock/gmock.h>

#include <linelet/io/point_file.h>

#include "run_tool.h"

using namespace linelet;

namespace {

using linelet::test::Outcome;
using linelet::test::ToolTest;

class SeveralInputs : public ToolTest {
protected:
  /** \brief Ground and a wire, 60 m long; x cut at -8 and 5 into three tiles. */
  void
  writeTiles(const std::string& ending) const
  {
    boost::random::mt19937 random(3);
    boost::random::normal_distribution<double> normal;
    io::Cloud whole;
    whole.shift = Point(512000, 5427000, 200);
    std::vector<float> sizes;
    for (int tile = 0; tile < 3; ++tile) {
      io::Cloud part;
      part.shift = whole.shift;
      std::vector<float> part_sizes;
      while (part.points.size() < 1500) {
        const double a = 20 * normal(random), b = normal(random), c = normal(random);
        if ((a < -8 ? 0 : a < 5 ? 1 : 2) != tile)
          continue;
        const Point place =
            c < 0.3 ? Point(a, 8 * b, 0.1 * c) : Point(a, 0.03 * b, 9 + 0.03 * c);
        // On the grid that all files share.
        part.points.emplace_back((place * 100).array().round() / 100);
        part_sizes.push_back(0.5f + 0.25f * static_cast<float>(part.points.size() % 7));
      }
      whole.points.insert(whole.points.end(), part.points.begin(), part.points.end());
      sizes.insert(sizes.end(), part_sizes.begin(), part_sizes.end());
      part.set({"size", part_sizes, ""});
      io::writeCloud(path("tile_" + std::to_string(tile) + ending), part);
    }
    whole.set({"size", sizes, ""});
    io::writeCloud(path("whole" + ending), whole);
  }

  /** \brief Runs \a command on the whole and on the tiles, and expects the same
   * values. */
  void
  expectSame(const std::string& command, const std::string& ending) const
  {
    SCOPED_TRACE(command);
    runWell(command + " " + path("whole" + ending) + " " + path("out" + ending));
    std::string tiles;
    for (int tile = 0; tile < 3; ++tile)
      tiles += path("tile_" + std::to_string(tile) + ending) + " ";
    runWell(command + " " + tiles + path("outs"));
    const io::Cloud whole = io::readCloud(path("out" + ending));
    std::size_t first = 0;
    for (int tile = 0; tile < 3; ++tile) {
      const io::Cloud part =
          io::readCloud(path("outs/tile_" + std::to_string(tile) + ending));
      ASSERT_EQ(part.points.size(), 1500u);
      for (const io::Column& column : part.columns) {
        const io::Column* same = whole.find(column.name);
        ASSERT_NE(same, nullptr) << column.name;
        for (std::size_t i = 0; i < part.points.size(); ++i) {
          const double a = io::valueAt(column, i), b = io::valueAt(*same, first + i);
          ASSERT_EQ(std::memcmp(&a, &b, sizeof a), 0)
              << column.name << " of point " << i << " of tile " << tile << ": " << a
              << ", in the whole " << b;
        }
      }
      first += part.points.size();
    }
  }
};

} // namespace

TEST_F(SeveralInputs, HaveTheTensorsOfTheWhole)
{
  writeTiles(".las");
  expectSame("tensor --radius 2", ".las");
  expectSame("tensor --radius 1.1 --weight const --centroid mean", ".las");
  expectSame("tensor --radius 2 --engine tree", ".las");
  expectSame("tensor --knn 15", ".las");
  expectSame("tensor --radius-field size", ".las");
  writeTiles(".laz");
  expectSame("tensor --radius 2", ".laz");
  writeTiles(".ply");
  expectSame("tensor --radius 2", ".ply");
}

TEST_F(SeveralInputs, HaveTheShapesOfTheWhole)
{
  writeTiles(".las");
  expectSame("multiscale --radii 0.5,1,2,4 --engine grid", ".las");
  expectSame("multiscale --radii 0.5,1,2,4 --centroid mean", ".las");
}

TEST_F(SeveralInputs, OfDifferentReferenceSystemsAreRefusedWithBothNames)
{
  writeTiles(".las");
  runWell("convert --crs EPSG:25832 " + path("tile_0.las") + " " + path("a.las"));
  runWell("convert --crs EPSG:25833 " + path("tile_1.las") + " " + path("b.las"));
  for (const std::string command :
       {"tensor --radius 2", "multiscale", "curves", "powerlines", "convert", "info"}) {
    const Outcome outcome =
        run(command + " " + path("a.las") + " " + path("b.las") +
            (command == "info" ? "" : " " + path(command == "curves" ? "c.obj" : "o")));
    EXPECT_EQ(outcome.code, 1) << command;
    EXPECT_THAT(outcome.error, testing::HasSubstr("ETRS89 / UTM zone 32N")) << command;
    EXPECT_THAT(outcome.error, testing::HasSubstr("ETRS89 / UTM zone 33N")) << command;
  }
}
