// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

#include <bench/runs/benchmark.h>
#include <bench/runs/benchmark_summary.h>

using namespace linelet;
using namespace linelet::bench;

namespace {

std::vector<BenchmarkRun>
fewRuns()
{
  const BenchmarkGrid grid;
  std::vector<BenchmarkRun> runs;
  for (const std::size_t index : grid.stratifiedSample(12, 5)) {
    runs.push_back(grid.at(index));
    runs.back().sampling.points = 64;
    runs.back().sampling.outliers = 6;
  }
  return runs;
}

/** \brief One straight curve through the first and last point. */
CurveNetwork
chord(const Points& points, ProgressMonitor* monitor)
{
  monitor->begin("shape", 3);
  monitor->begin("curves", 1);
  Curve curve;
  curve.points = {points.front(), points.back()};
  return {{curve}, {}};
}

std::vector<std::string>
rowsOf(unsigned threads)
{
  std::vector<std::string> lines;
  runBenchmark(
      "chord",
      fewRuns(),
      chord,
      [&](BenchmarkRow row) {
        row.feature_ms = row.reconstruction_ms = 0;
        std::ostringstream line;
        writeCsv(line, row);
        lines.push_back(line.str());
      },
      threads);
  std::sort(lines.begin(), lines.end());
  return lines;
}

} // namespace

TEST(Benchmark, RowsDoNotDependOnThreads)
{
  const auto one = rowsOf(1);
  EXPECT_EQ(one.size(), 12u);
  EXPECT_EQ(one, rowsOf(4));
}

TEST(Benchmark, RowsAreTheMeasuresOfTheirRun)
{
  BenchmarkRun run;
  run.geometry = Geometry::Line;
  const BenchmarkRow row = perform("chord", run, chord);
  // Samples stop one spacing short of the end.
  EXPECT_NEAR(row.measures.e_len, 255.0 / 256, 1e-9);
  EXPECT_NEAR(row.measures.e_com, 255.0 / 256, 1e-9);
  EXPECT_TRUE(row.measures.success);
  EXPECT_NEAR(row.noise_rate, 0, 1e-6);
  EXPECT_GE(row.feature_ms, 0);
  EXPECT_GE(row.reconstruction_ms, 0);
}

TEST(Benchmark, NoiseRateGrowsWithJitter)
{
  double last = -1;
  for (const double jitter : {0.0, 0.3, 0.6}) {
    BenchmarkRun run;
    run.geometry = Geometry::Helix;
    run.sampling.jitter = jitter;
    const double rate = perform("chord", run, chord).noise_rate;
    EXPECT_GT(rate, last);
    last = rate;
  }
}

TEST(Benchmark, RowsSurviveTheirFile)
{
  std::ostringstream out;
  out << benchmark_csv_header << '\n';
  std::vector<BenchmarkRow> rows;
  runBenchmark(
      "chord", fewRuns(), chord, [&](const BenchmarkRow& r) { rows.push_back(r); }, 1);
  rows[3].measures.e_h = rows[3].measures.e_v = std::nan("");
  for (const BenchmarkRow& row : rows)
    writeCsv(out, row);
  std::istringstream in(out.str());
  const auto read = readCsv(in);
  ASSERT_EQ(read.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(keyOf(read[i].method, read[i].run), keyOf(rows[i].method, rows[i].run));
    EXPECT_EQ(read[i].measures.success, rows[i].measures.success);
    EXPECT_NEAR(read[i].measures.e_len, rows[i].measures.e_len, 1e-5);
    EXPECT_EQ(std::isnan(read[i].measures.e_v), i == 3);
  }
}

TEST(Benchmark, ATruncatedLineIsNotARow)
{
  std::ostringstream out;
  out << benchmark_csv_header << '\n';
  const BenchmarkRow row = perform("chord", fewRuns().front(), chord);
  writeCsv(out, row);
  writeCsv(out, row);
  const std::string text = out.str();
  // The cut may fall inside the last number, and what is left still looks like one.
  std::istringstream cut(text.substr(0, text.size() - 3));
  EXPECT_EQ(readCsv(cut).size(), 1u);
  std::istringstream other("x,y\n1,2\n");
  EXPECT_THROW(readCsv(other), std::runtime_error);
}

TEST(Benchmark, KeysTellRunsApart)
{
  const BenchmarkGrid grid;
  std::set<std::string> keys;
  for (const std::size_t index : grid.stratifiedSample(3000, 1))
    keys.insert(keyOf("a", grid.at(index)));
  EXPECT_EQ(keys.size(), 3000u);
  EXPECT_NE(keyOf("a", grid.at(0)), keyOf("b", grid.at(0)));
}

TEST(Benchmark, FailuresAndCancellationComeThrough)
{
  const auto nothing = [](const BenchmarkRow&) {};
  const auto fail = [](const Points&, ProgressMonitor*) -> CurveNetwork {
    throw std::logic_error("broken");
  };
  EXPECT_THROW(runBenchmark("x", fewRuns(), fail, nothing, 2), std::logic_error);
  struct : ProgressMonitor {
    bool
    canceled() const override
    {
      return true;
    }
  } monitor;
  EXPECT_THROW(runBenchmark("x", fewRuns(), chord, nothing, 2, &monitor), Canceled);
}

TEST(Benchmark, SummaryCountsSuccesses)
{
  std::vector<BenchmarkRow> rows(4);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].run.geometry = i < 3 ? Geometry::Circle : Geometry::Line;
    rows[i].measures.success = i == 0;
    rows[i].measures.e_v = i == 1 ? std::nan("") : 0.5;
    rows[i].reconstruction_ms = 10;
  }
  const std::string table = summaryTable(rows);
  const auto lineOf = [&](const std::string& name) {
    const auto at = table.find("  " + name + " ");
    return table.substr(at, table.find('\n', at) - at);
  };
  EXPECT_NE(lineOf("all").find("  4    0.250   0.500"), std::string::npos) << table;
  EXPECT_NE(lineOf("circle").find("  3    0.333   0.500"), std::string::npos) << table;
  EXPECT_NE(lineOf("line").find("  1    0.000   0.500"), std::string::npos) << table;
}
