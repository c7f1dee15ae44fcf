// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include <gtest/gtest.h>

#include <bench/geometries/test_cloud.h>
#include <bench/measures/measures.h>
#include <linelet/curves/streamline_reconstruction.h>

namespace linelet::test {

using bench::Geometry;

inline CurveNetwork
reconstruct(Geometry geometry,
            std::size_t points,
            const StreamlineSettings& settings = {})
{
  bench::SamplingSettings sampling;
  sampling.points = points;
  return reconstructPublished(bench::sample(geometry, sampling), settings);
}

inline void
expectSame(const CurveNetwork& a, const CurveNetwork& b)
{
  ASSERT_EQ(a.curves.size(), b.curves.size());
  for (std::size_t i = 0; i < a.curves.size(); ++i)
    EXPECT_EQ(a.curves[i].points, b.curves[i].points);
}

} // namespace linelet::test
