// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Power lines merged from overlapping parts are those of the whole cloud, however it
// was cut.

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <linelet/io/point_file.h>
#include <linelet/powerline/extract_power_lines.h>
#include <linelet/powerline/network_part.h>

#include "random_seed.h"

namespace linelet::powerline {
namespace {

/** \brief A grid of boxes with any origin. */
struct Boxes {
  double x, y, side;

  std::pair<long, long>
  of(double at_x, double at_y) const
  {
    return {std::lround(std::floor((at_x - x) / side)),
            std::lround(std::floor((at_y - y) / side))};
  }
};

struct Merged {
  PowerLineNetwork network;
  std::vector<int> wire_of_point; ///< id, by the part that owns the point
  std::vector<std::uint8_t> classes;
  std::size_t parts = 0;
};

Merged
inParts(const Points& points, const Boxes& boxes, double overlap)
{
  Point low = points.front(), high = low;
  for (const Point& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  std::vector<NetworkPart> parts;
  std::vector<std::vector<std::pair<std::size_t, int>>> labels;
  Merged merged;
  merged.wire_of_point.assign(points.size(), -1);
  merged.classes.assign(points.size(), 255);
  const auto first = boxes.of(low.x(), low.y()), last = boxes.of(high.x(), high.y());
  for (long i = first.first; i <= last.first; ++i)
    for (long j = first.second; j <= last.second; ++j) {
      const double x = boxes.x + static_cast<double>(i) * boxes.side,
                   y = boxes.y + static_cast<double>(j) * boxes.side;
      Points here;
      std::vector<std::size_t> places;
      for (std::size_t k = 0; k < points.size(); ++k) {
        const Point& p = points[k];
        if (p.x() < x - overlap || p.x() >= x + boxes.side + overlap ||
            p.y() < y - overlap || p.y() >= y + boxes.side + overlap)
          continue;
        here.push_back(p);
        places.push_back(k);
      }
      NetworkPart part;
      PowerLineSettings settings;
      settings.threads = 1;
      const PowerLineNetwork found =
          extractPowerLines(here, {}, settings, nullptr, &part);
      const std::pair<long, long> box(i, j);
      part.owns = [boxes, box](double at_x, double at_y) {
        return boxes.of(at_x, at_y) == box;
      };
      labels.emplace_back();
      for (std::size_t k = 0; k < here.size(); ++k)
        if (part.owns(here[k].x(), here[k].y())) {
          labels.back().emplace_back(places[k], found.wire_id[k]);
          merged.classes[places[k]] = found.classes[k];
        }
      parts.push_back(std::move(part));
    }
  merged.parts = parts.size();
  std::vector<PartIds> ids;
  merged.network = mergeParts(parts, ids);
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (const auto& [place, id] : labels[p])
      merged.wire_of_point[place] = ids[p].wires.at(static_cast<std::size_t>(id));
  return merged;
}

void
expectSame(const PowerLineNetwork& parts, const PowerLineNetwork& whole, double apart)
{
  ASSERT_EQ(parts.wires.size(), whole.wires.size());
  ASSERT_EQ(parts.spans.size(), whole.spans.size());
  ASSERT_EQ(parts.circuits.size(), whole.circuits.size());
  ASSERT_EQ(parts.supports.size(), whole.supports.size());
  for (std::size_t w = 0; w < whole.wires.size(); ++w) {
    const Wire &a = parts.wires[w], &b = whole.wires[w];
    EXPECT_LE((a.front - b.front).norm(), apart) << "wire " << b.id;
    EXPECT_LE((a.back - b.back).norm(), apart) << "wire " << b.id;
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.span, b.span);
    EXPECT_EQ(a.circuit, b.circuit);
    EXPECT_EQ(a.number, b.number);
    EXPECT_EQ(a.front_support, b.front_support);
    EXPECT_EQ(a.back_support, b.back_support);
    EXPECT_EQ(a.points, b.points);
    EXPECT_NEAR(a.confidence, b.confidence, 1e-9);
  }
  for (std::size_t k = 0; k < whole.spans.size(); ++k) {
    EXPECT_EQ(parts.spans[k].wires, whole.spans[k].wires);
    EXPECT_EQ(parts.spans[k].from_support, whole.spans[k].from_support);
    EXPECT_EQ(parts.spans[k].to_support, whole.spans[k].to_support);
  }
  for (std::size_t k = 0; k < whole.circuits.size(); ++k) {
    EXPECT_EQ(parts.circuits[k].spans, whole.circuits[k].spans);
    EXPECT_EQ(parts.circuits[k].supports, whole.circuits[k].supports);
  }
  for (std::size_t k = 0; k < whole.supports.size(); ++k) {
    EXPECT_LE((parts.supports[k].base - whole.supports[k].base).norm(), apart);
    EXPECT_EQ(parts.supports[k].kind, whole.supports[k].kind);
    EXPECT_EQ(parts.supports[k].points, whole.supports[k].points);
  }
}

class MergeParts : public testing::Test {
protected:
  void
  SetUp() override
  {
    cloud_ = io::readCloud(std::string(LINELET_SOURCE_DIR) + "/data/corridor.las");
    PowerLineSettings settings;
    settings.threads = 1;
    NetworkPart part; // for the seeds of one
    whole_ = extractPowerLines(cloud_.points, {}, settings, nullptr, &part);
  }

  io::Cloud cloud_;
  PowerLineNetwork whole_;
};

// Boxes of any origin, much narrower than a span (219 m), that overlap by the longest
// span plus its fittings.
TEST_F(MergeParts, OfRandomTilingsAreTheWhole)
{
  std::mt19937 random(test::randomSeed());
  std::uniform_real_distribution<double> anywhere(-1000, 1000), side(90, 250);
  ASSERT_GT(whole_.wires.size(), 20U);
  for (int round = 0; round < 3; ++round) {
    const Boxes boxes{anywhere(random), anywhere(random), side(random)};
    const Merged merged = inParts(cloud_.points, boxes, 300);
    SCOPED_TRACE("round " + std::to_string(round) + ", side " +
                 std::to_string(boxes.side));
    EXPECT_GT(merged.parts, 2U);
    expectSame(merged.network, whole_, 1e-3);
    EXPECT_TRUE(std::equal(merged.wire_of_point.begin(),
                           merged.wire_of_point.end(),
                           whole_.wire_id.begin()));
    EXPECT_TRUE(merged.classes == whole_.classes);
  }
}

// A single part is the whole: merging it changes no bit.
TEST_F(MergeParts, OfOneIsTheSame)
{
  const Merged merged = inParts(cloud_.points, {-1e5, -1e5, 1e6}, 0);
  ASSERT_EQ(merged.parts, 1U);
  expectSame(merged.network, whole_, 0);
  ASSERT_EQ(merged.network.unexplained.size(), whole_.unexplained.size());
  for (std::size_t k = 0; k < whole_.unexplained.size(); ++k)
    EXPECT_EQ(merged.network.unexplained[k].length, whole_.unexplained[k].length);
}

// An unexplained line cut by a border is joined again.
TEST(PartsOfLines, AreJoinedAtBorders)
{
  UnexplainedLine line;
  for (int k = 0; k <= 50; ++k)
    line.course.emplace_back(2.0 * k, 1, 10);
  line.length = 100;
  line.points = 400;
  std::vector<NetworkPart> parts(3);
  for (int p = 0; p < 3; ++p) {
    parts[static_cast<std::size_t>(p)].unexplained = {line};
    parts[static_cast<std::size_t>(p)].owns = [p](double x, double) {
      return x < 33.3 ? p == 0 : x < 71.7 ? p == 1 : p == 2;
    };
  }
  std::vector<PartIds> ids;
  const PowerLineNetwork merged = mergeParts(parts, ids);
  ASSERT_EQ(merged.unexplained.size(), 1U);
  EXPECT_NEAR(merged.unexplained[0].length, 100, 1e-6);
  EXPECT_NEAR(static_cast<double>(merged.unexplained[0].points), 400, 2);
}

TEST(PartsOfLines, OfNothingAreNothing)
{
  std::vector<PartIds> ids;
  EXPECT_TRUE(mergeParts({}, ids).wires.empty());
  NetworkPart empty;
  empty.owns = [](double, double) { return true; };
  EXPECT_TRUE(mergeParts({empty, empty}, ids).wires.empty());
  EXPECT_EQ(ids.size(), 2U);
}

} // namespace
} // namespace linelet::powerline
