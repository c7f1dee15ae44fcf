// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <bench/geometries/geometries.h>
#include <bench/geometries/random_cloud.h>
#include <bench/geometries/test_cloud.h>

namespace linelet::bench {

/** \brief One run of the benchmark: a geometry, or a kind of random shapes, and how it
 * is sampled. */
struct BenchmarkRun {
  Geometry geometry = Geometry::Circle;
  std::optional<RandomCloudKind> random; ///< instead of the geometry
  SamplingSettings sampling;
};

/** \brief What is sampled in \a run: the name of the geometry or kind. */
std::string
shapeName(const BenchmarkRun& run);

/** \brief The grid of runs: geometry x N x S_D x S_J x M x seed.
 *
 * N in {128, 256, 512}, S_D and S_J in {0, 0.1, ... 1}, M in {0, 0.1 N, ... 0.4 N},
 * seeds 1 to 7; with the ten geometries of the benchmark 127,050 runs. */
class BenchmarkGrid {
public:
  explicit BenchmarkGrid(
      const std::vector<Geometry>& geometries = benchmarkGeometries());

  std::size_t
  size() const;

  /** \brief Run number \a index (below \ref size). */
  BenchmarkRun
  at(std::size_t index) const;

  /** \brief \a count different runs, ascending: every combination of geometry, N and
   * S_J equally often, and every S_D, M and seed equally often (up to rounding). The
   * whole grid if count is its size or more, or 0. The same for the same seed on every
   * machine. */
  std::vector<std::size_t>
  stratifiedSample(std::size_t count, std::uint64_t seed) const;

private:
  std::vector<Geometry> geometries_;
};

} // namespace linelet::bench
