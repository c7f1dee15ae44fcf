// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Every place is owned once, by the box that claims it; expected values follow from the
// definition of a half-open box, over all boxes.

#include <cmath>
#include <filesystem>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <linelet/fragments/ledger.h>
#include <linelet/fragments/plan.h>
#include <linelet/fragments/tiling.h>
#include <linelet/io/file_error.h>

#include "random_seed.h"

namespace linelet::fragments {

namespace {

/** The boxes as cut. */
void
areasOf(const Tiling& tiling, int node, Area area, std::vector<Area>& areas)
{
  if (node < 0) {
    areas.at(static_cast<std::size_t>(-1 - node)) = area;
    return;
  }
  const Tiling::Cut& cut = tiling.cuts()[static_cast<std::size_t>(node)];
  Area below = area, above = area;
  below.high[static_cast<std::size_t>(cut.axis)] = cut.plane;
  above.low[static_cast<std::size_t>(cut.axis)] = cut.plane;
  areasOf(tiling, cut.below, below, areas);
  areasOf(tiling, cut.above, above, areas);
}

std::vector<Area>
areasOf(const Tiling& tiling)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  std::vector<Area> areas(tiling.boxes());
  areasOf(
      tiling, tiling.cuts().empty() ? -1 : 0, {{-none, -none}, {none, none}}, areas);
  return areas;
}

bool
holds(const Area& area, double x, double y)
{
  return x >= area.low[0] && x < area.high[0] && y >= area.low[1] && y < area.high[1];
}

std::vector<Extent>
randomExtents(std::mt19937& random)
{
  std::uniform_real_distribution<double> place(-1000, 1000), side(0, 300);
  std::vector<Extent> extents(1 + random() % 20);
  for (Extent& extent : extents) {
    for (std::size_t a = 0; a < 2; ++a) {
      extent.area.low[a] = place(random);
      extent.area.high[a] = extent.area.low[a] + (random() % 8 == 0 ? 0 : side(random));
    }
    extent.points = static_cast<double>(random() % 100000);
  }
  return extents;
}

} // namespace

TEST(Tiling, OfNothingIsOneBox)
{
  for (const Tiling& tiling : {Tiling(), Tiling({}, {1, 1, 1})}) {
    EXPECT_EQ(tiling.boxes(), 1u);
    EXPECT_EQ(tiling.owner(1e9, -1e9), 0u);
    EXPECT_EQ(tiling.near({{0, 0}, {1, 1}}, 5), std::vector<std::size_t>{0});
  }
}

// A file whose points all coincide cannot be cut.
TEST(Tiling, OnePlaceIsOneBox)
{
  const Tiling tiling({{{{5, 5}, {5, 5}}, 1e9}}, {0, 0, 10});
  EXPECT_EQ(tiling.boxes(), 1u);
}

TEST(Tiling, InvalidNumbersAreRefused)
{
  const std::vector<Extent> some = {{{{0, 0}, {1, 1}}, 5}};
  EXPECT_THROW(Tiling(some, {-1, 0, 0}), std::invalid_argument);
  EXPECT_THROW(Tiling(some, {0, std::nan(""), 0}), std::invalid_argument);
  EXPECT_THROW(Tiling({{0, 1, 5, -1}}), std::invalid_argument);
}

TEST(Tiling, EveryPlaceIsOwnedOnceAndNearWhereItShouldBe)
{
  const unsigned seed = test::randomSeed();
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1500, 1500), width(0, 50);
  for (int run = 0; run < 60; ++run) {
    const double ghost = width(random);
    const double chunk = random() % 2 == 0 ? 0 : 50 + width(random) * 5;
    const Tiling tiling(randomExtents(random),
                        {ghost, chunk, static_cast<double>(random() % 30000)});
    const std::vector<Area> areas = areasOf(tiling);
    for (std::size_t box = 0; box < areas.size(); ++box) {
      EXPECT_EQ(tiling.box(box).low, areas[box].low);
      EXPECT_EQ(tiling.box(box).high, areas[box].high);
    }
    for (int i = 0; i < 300; ++i) {
      double x = place(random), y = place(random);
      if (random() % 3 == 0) { // on a border
        const Area& area = areas[random() % areas.size()];
        x = std::isfinite(area.low[0]) ? area.low[0] : x;
        y = std::isfinite(area.high[1]) ? area.high[1] : y;
      }
      const std::size_t owner = tiling.owner(x, y);
      std::vector<bool> called(areas.size(), false);
      tiling.forEachNear(x, y, ghost, [&](std::size_t f) {
        EXPECT_FALSE(called[f]) << "twice, seed " << seed;
        called[f] = true;
      });
      for (std::size_t f = 0; f < areas.size(); ++f) {
        EXPECT_EQ(holds(areas[f], x, y), f == owner);
        const Area& a = areas[f];
        const bool within = x >= a.low[0] - ghost && x < a.high[0] + ghost &&
                            y >= a.low[1] - ghost && y < a.high[1] + ghost;
        EXPECT_EQ(called[f], within);
      }
      const auto near = tiling.near({{x, y}, {x, y}}, ghost);
      EXPECT_EQ(
          static_cast<std::size_t>(std::count(called.begin(), called.end(), true)),
          near.size());
    }
    EXPECT_EQ(areasOf(Tiling(tiling.cuts())).size(), areas.size());
  }
}

// A crowded tile among empty ones is cut, the others are not.
TEST(Tiling, CrowdedBoxesAreCutFurther)
{
  std::vector<Extent> extents;
  for (int i = 0; i < 4; ++i)
    extents.push_back(
        {{{i * 100.0, 0}, {i * 100.0 + 100, 100}}, i == 1 ? 64000. : 1000.});
  const Tiling tiling(extents, {1, 100, 2500});
  std::size_t crowded = 0;
  for (const Area& area : areasOf(tiling)) {
    const double x = std::max(area.low[0], 0.0);
    crowded += x >= 100 && x < 200 ? 1 : 0;
  }
  EXPECT_GE(crowded, 32u);
  EXPECT_LE(tiling.boxes() - crowded, 6u);
}

// A corridor is cut into as few boxes as can hold their points and those of their ghost
// zones; repeated halving may leave boxes half empty.
TEST(Tiling, BoxesAreAsFullAsTheyMayBe)
{
  constexpr double ghost = 300, tile = 140, most = 12e6;
  for (const int tiles : {45, 80, 100, 320, 333}) {
    std::vector<Extent> extents;
    for (int i = 0; i < tiles; ++i)
      extents.push_back({{{i * tile, 0}, {(i + 1) * tile, 400}}, 625e3});
    const Tiling tiling(extents, {ghost, 0, most});
    const double slice = most / 625e3 * tile - 2 * ghost;
    EXPECT_LE(static_cast<double>(tiling.boxes()), std::ceil(tiles * tile / slice) + 1)
        << tiles;
    for (std::size_t box = 0; box < tiling.boxes(); ++box) {
      const Area area = tiling.box(box);
      const double from = std::max(area.low[0] - ghost, 0.0),
                   to = std::min(area.high[0] + ghost, tiles * tile);
      EXPECT_LE((to - from) / tile * 625e3, most * (1 + 1e-9)) << tiles;
    }
  }
}

// Plans of country size: 10,000 tiles of 100 million points.
TEST(Tiling, ManyTilesAreQuick)
{
  std::vector<Extent> extents;
  for (int i = 0; i < 10000; ++i)
    extents.push_back({{{i % 100 * 1000.0, i / 100 * 1000.0},
                        {i % 100 * 1000.0 + 1000, i / 100 * 1000.0 + 1000}},
                       1e8});
  const Tiling tiling(extents, {1, 0, 2e7});
  EXPECT_GE(tiling.boxes(), 50000u);
  EXPECT_LE(tiling.boxes(), 200000u);
}

namespace {

std::string
freshFolder()
{
  std::string name =
      (std::filesystem::temp_directory_path() / "linelet-XXXXXX").string();
  return ::mkdtemp(name.data());
}

} // namespace

TEST(Plan, IsReadBackAsItWas)
{
  const std::string folder = freshFolder();
  Plan plan;
  plan.version = "1";
  plan.command = "tensor";
  plan.arguments = {"--radius", "1", "a \"b\".las"};
  plan.shift = Point(1.0 / 3, 5e5, -7);
  plan.ghost = 0.1;
  plan.most_points = 1e7 / 3;
  plan.inputs = {{"a.las", 17, -5, {{{0, 1.0 / 7}, {1e6, 2}}, 33}, -1, 4}};
  plan.tiling = Tiling({plan.inputs[0].extent}, {0, 1e5, 0});
  savePlan(plan, folder);
  const Plan again = loadPlan(folder);
  EXPECT_EQ(again.fingerprint(), plan.fingerprint());
  EXPECT_EQ(again.inputs[0].changed, -5);
  EXPECT_EQ(again.tiling.boxes(), plan.tiling.boxes());
  plan.arguments.back() = "other.las";
  EXPECT_NE(again.fingerprint(), plan.fingerprint());
  std::filesystem::resize_file(folder + "/plan.json", 40);
  EXPECT_THROW(loadPlan(folder), io::FileError);
  std::filesystem::remove_all(folder);
  EXPECT_THROW(loadPlan(folder), io::FileError);
}

TEST(Ledger, EntriesOfAnotherPlanOrHalfWrittenDoNotCount)
{
  const std::string folder = freshFolder();
  const Ledger ledger(folder, "abc");
  EXPECT_FALSE(ledger.find(Ledger::task, 3));
  Ledger::Entry entry;
  entry.done = true;
  entry.points = 5;
  entry.pieces = {{1, 10}, {7, 20}};
  entry.figures = {{"sum", 0.1}};
  ledger.write(Ledger::task, 3, entry);
  ASSERT_TRUE(ledger.done(Ledger::task, 3));
  EXPECT_EQ(ledger.find(Ledger::task, 3)->pieces, entry.pieces);
  EXPECT_EQ(ledger.find(Ledger::task, 3)->figures, entry.figures);
  EXPECT_FALSE(ledger.done(Ledger::cut, 3));
  EXPECT_FALSE(Ledger(folder, "abd").done(Ledger::task, 3));
  std::filesystem::resize_file(ledger.path(Ledger::task, 3), 20);
  EXPECT_FALSE(ledger.done(Ledger::task, 3));
  entry.done = false;
  ledger.write(Ledger::task, 4, entry);
  EXPECT_TRUE(ledger.find(Ledger::task, 4));
  ledger.forgetFailures();
  EXPECT_FALSE(ledger.find(Ledger::task, 4));
  std::filesystem::remove_all(folder);
}

} // namespace linelet::fragments
