// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <bench/runs/benchmark_grid.h>

namespace linelet::bench {

/** \brief \a count runs on random shapes, none of which another \a seed draws.
 *
 * Every family in the plane and in space under every kind of noise comes equally often
 * (up to rounding). N is one of {100, 150, 250, 400, 800}, S_D of {0, 0.5, 1}, S_J of
 * {0, 0.1, 0.2, 0.4, 0.6} and M of {0, 0.1 N, ... 0.4 N}. */
std::vector<BenchmarkRun>
randomRuns(std::size_t count, std::uint32_t seed);

} // namespace linelet::bench
