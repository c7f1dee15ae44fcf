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

/** \brief What a picture of a benchmark shows, in one panel each by geometry, number of
 * points, noise and noise rate. */
enum class BenchmarkView {
  Success,  ///< one bar per method, with whiskers of one standard error
  Distances ///< of E_V, a box per method: quartiles and median, whiskers at 5 and 95 %
};

Canvas
drawBenchmark(const std::vector<MethodRows>& methods,
              BenchmarkView view,
              int width,
              int height);

} // namespace linelet::apps
