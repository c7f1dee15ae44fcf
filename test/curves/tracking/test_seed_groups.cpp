// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Seeds are grouped by what is near them: a part of a cloud gets the same groups as the
// whole cloud there.

#include "curves/tracking/seed_groups.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "random_seed.h"

namespace linelet::test {
namespace {

constexpr double side = 5;

/** Seeds at random places, the best first; their index is their number. */
std::vector<TrackSeed>
someSeeds(std::mt19937& random, std::size_t count)
{
  std::uniform_real_distribution<double> place(-20, 20);
  std::vector<TrackSeed> seeds(count);
  for (std::size_t k = 0; k < count; ++k) {
    seeds[k].index = static_cast<Index>(k);
    seeds[k].at = {place(random), place(random), place(random) / 20};
    seeds[k].quality = 1 - static_cast<double>(k) / static_cast<double>(count);
  }
  return seeds;
}

Point
cellOf(const TrackSeed& seed)
{
  return (seed.at / side).array().floor();
}

bool
isOpen(const TrackSeed& seed)
{
  return seed.index % 7 != 3;
}

std::vector<std::vector<TrackSeed>>
groupsOf(const std::vector<TrackSeed>& seeds, std::size_t most)
{
  SeedGroups groups(seeds, side);
  std::vector<std::vector<TrackSeed>> all;
  for (auto group = groups.next(most, isOpen); !group.empty();
       group = groups.next(most, isOpen))
    all.push_back(group);
  EXPECT_EQ(groups.passed(), seeds.size());
  return all;
}

TEST(SeedGroups, EachOpenSeedIsHandedOutOnceTheBestFirst)
{
  std::mt19937 random(randomSeed());
  const std::vector<TrackSeed> seeds = someSeeds(random, 3000);
  std::vector<int> times(seeds.size(), 0);
  Index first = 0;
  for (const auto& group : groupsOf(seeds, 8)) {
    EXPECT_LE(group.size(), 8U);
    EXPECT_GE(group.front().index, first) << "a better one was left";
    first = group.front().index;
    for (const TrackSeed& seed : group) {
      ++times[seed.index];
      EXPECT_EQ(cellOf(seed), cellOf(group.front()));
      EXPECT_GE(seed.index, group.front().index);
    }
  }
  for (const TrackSeed& seed : seeds)
    EXPECT_EQ(times[seed.index], isOpen(seed) ? 1 : 0);
}

TEST(SeedGroups, OfAPartAreThoseOfTheWhole)
{
  std::mt19937 random(randomSeed());
  const std::vector<TrackSeed> seeds = someSeeds(random, 3000);
  const auto isPart = [](const TrackSeed& seed) { return cellOf(seed).x() < 1; };
  std::vector<TrackSeed> part;
  for (const TrackSeed& seed : seeds)
    if (isPart(seed))
      part.push_back(seed);
  const auto groups = groupsOf(part, 4);
  std::size_t next = 0;
  for (const auto& group : groupsOf(seeds, 4)) {
    if (!isPart(group.front()))
      continue;
    ASSERT_LT(next, groups.size());
    ASSERT_EQ(groups[next].size(), group.size());
    for (std::size_t k = 0; k < group.size(); ++k)
      EXPECT_EQ(groups[next][k].index, group[k].index);
    ++next;
  }
  EXPECT_EQ(next, groups.size());
}

TEST(SeedGroups, NoneAndNoneOpen)
{
  const std::vector<TrackSeed> no_seeds;
  SeedGroups none(no_seeds, side);
  EXPECT_TRUE(none.next(8, isOpen).empty());
  std::vector<TrackSeed> closed(2);
  closed[0].index = closed[1].index = 3;
  for (TrackSeed& seed : closed)
    seed.at.setZero();
  SeedGroups groups(closed, side);
  EXPECT_TRUE(groups.next(8, isOpen).empty());
  EXPECT_EQ(groups.passed(), 2U);
  EXPECT_TRUE(groups.next(0, isOpen).empty());
}

} // namespace
} // namespace linelet::test
