// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include <bench/measures/measures.h>
#include <bench/runs/benchmark_grid.h>
#include <linelet/curves/curve_network.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>

namespace linelet::bench {

/** \brief The result of a run. */
struct BenchmarkRow {
  std::string method; ///< method that reconstructed the curves
  BenchmarkRun run;
  double noise_rate = 0; ///< n_R of the points
  Measures measures;
  double feature_ms = 0;        ///< wall time of the features, milliseconds
  double reconstruction_ms = 0; ///< wall time of everything after them
};

/** \brief Reconstructs curves in one thread; calls monitor->begin("curves", ...) once
 * the features are computed, if there are any. */
using Reconstruct =
    std::function<CurveNetwork(const Points& points, ProgressMonitor* monitor)>;

/** \brief Samples, reconstructs and measures \a run. */
BenchmarkRow
perform(const std::string& method,
        const BenchmarkRun& run,
        const Reconstruct& reconstruct,
        const ProgressMonitor* cancel = nullptr);

/** \brief Performs \a runs, several at a time.
 * \param[in] sink gets every row as it is finished, never from two threads at once
 * \param[in] threads 0: all
 * \throws Canceled, and whatever a reconstruction throws */
void
runBenchmark(const std::string& method,
             const std::vector<BenchmarkRun>& runs,
             const Reconstruct& reconstruct,
             const std::function<void(const BenchmarkRow&)>& sink,
             unsigned threads = 0,
             ProgressMonitor* monitor = nullptr);

/** \brief The first line of a file of rows. */
extern const char* const benchmark_csv_header;

/** \brief Writes \a row as a line of comma-separated values. */
void
writeCsv(std::ostream& out, const BenchmarkRow& row);

/** \brief Reads the rows of a file, skipping incomplete lines (such as the last one of
 * a benchmark that was killed).
 * \throws std::runtime_error if the first line is not \ref benchmark_csv_header */
std::vector<BenchmarkRow>
readCsv(std::istream& in);

/** \brief Equal for rows of the same run by the same method, and only for these. */
std::string
keyOf(const std::string& method, const BenchmarkRun& run);

} // namespace linelet::bench
