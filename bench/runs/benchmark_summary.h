// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <bench/runs/benchmark.h>

namespace linelet::bench {

/** \brief Results of some runs: means over those where the value is known. */
struct RunSummary {
  std::size_t runs = 0;
  double success = 0;                            ///< share of the runs, 0 to 1
  double e_v = 0, e_h = 0, e_len = 0, e_com = 0; ///< see measures.h
  double milliseconds = 0;                       ///< of a run
  /// Of E_V: the values below which 5, 25, 50, 75 and 95 % of the runs lie. NaN without
  /// runs.
  std::array<double, 5> e_v_quantiles{};

  /** \brief Standard error of \ref success; NaN below two runs. */
  double
  standardError() const;
};

/** \brief Runs grouped by one of their properties. */
struct SummaryGroup {
  std::string title; ///< the property: geometry, points, S_D, S_J, M / N, n_R or noise
  std::vector<std::pair<std::string, RunSummary>> entries; ///< a value each
};

/** \brief All \a rows as one group. */
RunSummary
summarize(const std::vector<BenchmarkRow>& rows);

/** \brief \a rows by geometry (in the order of the rows), number of points, noise and
 * intervals of the noise rate (by size), those of random shapes also by kind of noise.
 */
std::vector<SummaryGroup>
summarizeByProperty(const std::vector<BenchmarkRow>& rows);

/** \brief Both as a table in text form. */
std::string
summaryTable(const std::vector<BenchmarkRow>& rows);

} // namespace linelet::bench
