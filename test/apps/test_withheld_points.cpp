// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Points flagged as withheld are left out of every analysis, but stay unchanged in the
// written LAS file.

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include <linelet/io/point_file.h>
#include <linelet/io/usable_points.h>

#include "run_tool.h"
#include "test_data.h"

using namespace linelet;
using linelet::test::dataPath;
using linelet::test::Outcome;
using linelet::test::ToolTest;
using testing::HasSubstr;
using testing::Not;

namespace {

class WithheldPoints : public ToolTest {
protected:
  const std::string scan_ = std::string(LINELET_SOURCE_DIR) + "/data/corridor.las";

  struct Layout {
    std::size_t points, record; ///< offset of the first record, length of each
    std::size_t count;
    bool old; ///< formats 0 to 5: flags share the class byte
  };

  static Layout
  layoutOf(const std::string& bytes)
  {
    std::uint32_t points = 0, count = 0;
    std::uint16_t record = 0;
    std::memcpy(&points, &bytes[96], 4);
    std::memcpy(&record, &bytes[105], 2);
    const bool old = bytes[104] < 6;
    std::memcpy(&count, &bytes[old ? 107 : 247], 4);
    return {points, record, count, old};
  }

  /** \brief A copy of the sample scan in which every point that \a chosen picks by
   * index and class is flagged, in the bits of the LAS specification. */
  template <class Chosen>
  std::string
  flagged(const std::string& name, Chosen&& chosen) const
  {
    std::string bytes = contents(scan_);
    const Layout at = layoutOf(bytes);
    for (std::size_t i = 0; i < at.count; ++i) {
      char* record = &bytes[at.points + i * at.record];
      const int classification = at.old ? record[15] & 31 : record[16];
      if (chosen(i, classification))
        record[15] = static_cast<char>(record[15] | (at.old ? 0x80 : 0x04));
    }
    return write(name, bytes);
  }

  /** \brief The part of a record that its point format defines, without extra bytes. */
  static std::string
  record(const std::string& bytes, std::size_t i, std::size_t length)
  {
    const Layout at = layoutOf(bytes);
    return bytes.substr(at.points + i * at.record, length);
  }
};

bool
oneInThree(std::size_t i, int)
{
  return i % 3 == 1;
}

} // namespace

TEST_F(WithheldPoints, AreCountedByInfoAsOtherReadersCountThem)
{
  LINELET_NEEDS_DATA("readers/las/loadersgl_pdrf10-1.4.las");
  struct Expected {
    const char* file;
    int withheld, overlap, synthetic, key_point; // counted from the bytes of the file
  };
  for (const Expected& e : {Expected{"loadersgl_pdrf10-1.4.las", 483, 491, 551, 538},
                            Expected{"loadersgl_pdrf6-1.4.las", 494, 493, 548, 530},
                            Expected{"pdal_wontcompress3.las", 895, 1000, 0, 0}}) {
    SCOPED_TRACE(e.file);
    const Outcome info =
        runWell("info " + dataPath(std::string("readers/las/") + e.file).string() +
                " --json " + path("info.json"));
    EXPECT_THAT(info.out, HasSubstr("left out of every analysis"));
    const auto flags = json(path("info.json"))["flags"];
    EXPECT_EQ(flags["withheld"], e.withheld);
    EXPECT_EQ(flags["overlap"], e.overlap);
    EXPECT_EQ(flags["synthetic"], e.synthetic);
    EXPECT_EQ(flags["key_point"], e.key_point);
  }
  // Formats below 6 have no overlap flag; most of these points are synthetic.
  const Outcome old =
      runWell("info " + dataPath("readers/las/pdal_warsaw_small.las").string() +
              " --json " + path("info.json"));
  EXPECT_THAT(old.out, Not(HasSubstr("left out")));
  EXPECT_EQ(json(path("info.json"))["flags"],
            (nlohmann::json{{"withheld", 0}, {"synthetic", 2567}, {"key_point", 0}}));
}

TEST_F(WithheldPoints, OfAWireAreNotFoundAndStayAsTheyWere)
{
  const auto isWire = [](std::size_t, int classification) {
    return classification == 14;
  };
  const std::string file = flagged("wires.las", isWire);
  const Outcome run = runWell("powerlines " + file + " " + path("out"));
  EXPECT_THAT(run.error, HasSubstr("flagged as withheld"));
  EXPECT_THAT(run.out, HasSubstr("no wires found"));
  const std::string before = contents(file),
                    after = contents(path("out/classified.las"));
  const Layout layout = layoutOf(before);
  ASSERT_EQ(layoutOf(after).count, layout.count);
  for (std::size_t i = 0; i < layout.count; ++i)
    ASSERT_EQ(record(before, i, layout.record), record(after, i, layout.record)) << i;
}

TEST_F(WithheldPoints, ChangeNothingForTheOthers)
{
  const std::string file = flagged("third.las", oneInThree);
  const io::Cloud all = io::readCloud(file);
  io::Cloud rest;
  rest.shift = all.shift;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < all.points.size(); ++i)
    if (!oneInThree(i, 0)) {
      rest.points.push_back(all.points[i]);
      places.push_back(i);
    }
  ASSERT_EQ(io::UsablePoints(all).withheld(), all.points.size() - rest.points.size());
  io::writeCloud(path("rest.las"), rest);

  const auto compare = [&](const std::string& call,
                           const std::string& output,
                           const std::vector<std::string>& columns) {
    SCOPED_TRACE(call);
    runWell(call + " " + file + " " + path("a" + output));
    const std::string output_of_rest = path("b" + output);
    runWell(call + " " + path("rest.las") + " " + output_of_rest);
    const std::string inside = output.empty() ? "/classified.las" : "";
    const io::Cloud a = io::readCloud(path("a" + output) + inside);
    const io::Cloud b = io::readCloud(output_of_rest + inside);
    ASSERT_EQ(a.points.size(), all.points.size());
    for (const std::string& name : columns) {
      const io::Column* of_all = a.find(name);
      const io::Column* of_rest = b.find(name);
      ASSERT_TRUE(of_all != nullptr && of_rest != nullptr) << name;
      std::size_t different = 0;
      for (std::size_t k = 0; k < places.size(); ++k) {
        const double x = io::valueAt(*of_all, places[k]), y = io::valueAt(*of_rest, k);
        different += std::abs(x - y) > 1e-5 || std::isnan(x) != std::isnan(y) ? 1 : 0;
      }
      EXPECT_EQ(different, 0u) << name;
    }
  };
  // Noise is left out of files with classes; the other file has none.
  compare("tensor --ignore-classes none --radius 1.5",
          ".las",
          {"linearity", "neighbors", "lambda1"});
  compare("multiscale --ignore-classes none --radii 0.8,1.5",
          ".las",
          {"linearity", "optimal_radius"});
  compare(
      "powerlines --ignore-classes none", "", {"wire_id", "span_id", "wire_distance"});
}

TEST_F(WithheldPoints, HaveNoShapeButTheirOwnPlace)
{
  const std::string file = flagged("third.las", oneInThree);
  const std::string before = contents(file);
  const Layout layout = layoutOf(before);
  for (const std::string call :
       {"tensor --radius 1.5", "multiscale --radii 0.8,1.5 --centroid-shift 0.5"}) {
    SCOPED_TRACE(call);
    runWell(call + " " + file + " " + path("out.las"));
    const std::string after = contents(path("out.las"));
    const io::Cloud cloud = io::readCloud(path("out.las"));
    for (std::size_t i = 1; i < layout.count; i += 3) {
      ASSERT_TRUE(std::isnan(io::valueAt(*cloud.find("linearity"), i))) << i;
      ASSERT_EQ(record(before, i, layout.record), record(after, i, layout.record)) << i;
    }
  }
}
