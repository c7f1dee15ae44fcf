// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "support/parallel_failure.h"

#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

using linelet::ParallelFailure;

TEST(ParallelFailure, ThrowsNothingWhereNothingFailed)
{
  ParallelFailure failure;
  std::vector<int> done(100);
#pragma omp parallel for num_threads(4)
  for (int i = 0; i < 100; ++i)
    failure.guard([&] { done[static_cast<std::size_t>(i)] = 1; });
  EXPECT_FALSE(failure.failed());
  EXPECT_NO_THROW(failure.rethrow());
  for (const int one : done)
    EXPECT_EQ(one, 1);
}

// Without the guard the program would end in std::terminate.
TEST(ParallelFailure, CarriesAnExceptionOutOfAParallelRegion)
{
  ParallelFailure failure;
#pragma omp parallel for num_threads(4)
  for (int i = 0; i < 100; ++i)
    failure.guard([&] {
      if (i % 10 == 3)
        throw std::runtime_error("place 3");
    });
  EXPECT_TRUE(failure.failed());
  EXPECT_THROW(failure.rethrow(), std::runtime_error);
  // After a failure, nothing else starts.
  bool begun = false;
  failure.guard([&] { begun = true; });
  EXPECT_FALSE(begun);
}
