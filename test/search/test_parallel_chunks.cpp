// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "support/parallel_chunks.h"

#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace linelet {

namespace {

std::vector<int>
visits(std::size_t count, std::size_t chunk, unsigned threads)
{
  std::vector<int> seen(count, 0);
  forEachChunk(count, chunk, threads, [&](std::size_t begin, std::size_t end) {
    EXPECT_LT(begin, end);
    EXPECT_LE(end - begin, chunk);
    for (std::size_t i = begin; i < end; ++i)
      ++seen[i];
  });
  return seen;
}

} // namespace

TEST(ParallelChunks, EveryPlaceIsVisitedOnce)
{
  for (const unsigned threads : {1U, 2U, 5U})
    for (const std::size_t count : std::vector<std::size_t>{0, 1, 63, 64, 65, 1000})
      for (const std::size_t chunk : std::vector<std::size_t>{1, 64, 5000})
        EXPECT_EQ(visits(count, chunk, threads), std::vector<int>(count, 1));
}

TEST(ParallelChunks, EveryPlaceIsVisitedOnceInsideAParallelRegion)
{
  constexpr std::size_t loops = 6, count = 1000;
  std::vector<std::vector<int>> seen(loops);
  forEachChunk(
      loops, 1, 3, [&](std::size_t k, std::size_t) { seen[k] = visits(count, 7, 3); });
  for (const std::vector<int>& one : seen)
    EXPECT_EQ(one, std::vector<int>(count, 1));
}

TEST(ParallelChunks, ThrowsWhatOneOfThemThrows)
{
  const auto fails = [] {
    forEachChunk(100, 1, 3, [](std::size_t begin, std::size_t) {
      if (begin == 70)
        throw std::out_of_range("chunk 70");
    });
  };
  EXPECT_THROW(fails(), std::out_of_range);
  // Inside a parallel region only the calling thread throws.
  std::vector<char> thrown(4, 0);
  forEachChunk(thrown.size(), 1, 4, [&](std::size_t k, std::size_t) {
    try {
      if (k == 2)
        fails();
      else
        visits(100, 1, 4);
    }
    catch (const std::out_of_range&) {
      thrown[k] = 1;
    }
  });
  EXPECT_EQ(thrown, (std::vector<char>{0, 0, 1, 0}));
}

} // namespace linelet
