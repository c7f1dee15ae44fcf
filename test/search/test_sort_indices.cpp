// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "search/sort_indices.h"

#include <algorithm>
#include <limits>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <gtest/gtest.h>

using namespace linelet;

// Few and many, clustered and over the whole range, with equal values among them.
TEST(SortIndices, SortsAsComparingDoes)
{
  boost::random::mt19937 random(5);
  constexpr Index greatest = std::numeric_limits<Index>::max();
  for (const std::size_t count : {0U, 1U, 2U, 95U, 96U, 97U, 1000U, 70000U})
    for (const Index width : {0U, 1U, 255U, 256U, 65536U, 20000000U, greatest})
      for (const Index low : {Index{0}, Index{77}, greatest - width}) {
        const Index high = low > greatest - width ? greatest : low + width;
        boost::random::uniform_int_distribution<Index> any(low, high);
        Indices indices(count);
        for (Index& index : indices)
          index = any(random);
        Indices expected = indices;
        std::sort(expected.begin(), expected.end());
        sortIndices(indices);
        EXPECT_EQ(indices, expected) << count << " from " << low << " to " << high;
      }
}
