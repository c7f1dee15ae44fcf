// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <utility>
#include <vector>

#include <bench/runs/benchmark_summary.h>

#include "canvas.h"

namespace linelet::apps {

/** \brief A method and its rows, at least one. */
using MethodRows = std::pair<std::string, std::vector<bench::BenchmarkRow>>;

/** \brief What a picture of a benchmark shows by geometry, number of points, noise and
 * noise rate, a panel each. */
enum class BenchmarkView {
  Success,  ///< a bar a method, whiskers of one standard error
  Distances ///< of E_V, a box a method: quartiles and median; whiskers of 5 and 95 %
};

Canvas
drawBenchmark(const std::vector<MethodRows>& methods,
              BenchmarkView view,
              int width,
              int height);

} // namespace linelet::apps
