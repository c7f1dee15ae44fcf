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

} // namespace linelet::test
