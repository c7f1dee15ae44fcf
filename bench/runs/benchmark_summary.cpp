// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <bench/runs/benchmark_summary.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>

namespace linelet::bench {

namespace {

using Rows = std::vector<const BenchmarkRow*>;

template <class Value>
double
meanOf(const Rows& rows, Value&& value)
{
  double sum = 0, count = 0;
  for (const BenchmarkRow* row : rows)
    if (const double v = value(*row); std::isfinite(v)) {
      sum += v;
      ++count;
    }
  return sum / count;
}

/** \brief Values below which 5, 25, 50, 75 and 95 % of the finite ones lie,
 * interpolated linearly. */
template <class Value>
std::array<double, 5>
quantilesOf(const Rows& rows, Value&& value)
{
  std::vector<double> values;
  for (const BenchmarkRow* row : rows)
    if (const double v = value(*row); std::isfinite(v))
      values.push_back(v);
  std::sort(values.begin(), values.end());
  std::array<double, 5> result;
  result.fill(std::numeric_limits<double>::quiet_NaN());
  if (values.empty())
    return result;
  constexpr double shares[] = {0.05, 0.25, 0.5, 0.75, 0.95};
  for (std::size_t q = 0; q < result.size(); ++q) {
    const double place = shares[q] * static_cast<double>(values.size() - 1);
    const auto low = static_cast<std::size_t>(place);
    const std::size_t high = std::min(low + 1, values.size() - 1);
    result[q] =
        values[low] + (values[high] - values[low]) * (place - static_cast<double>(low));
  }
  return result;
}

RunSummary
summaryOf(const Rows& rows)
{
  RunSummary summary;
  summary.runs = rows.size();
  summary.success =
      meanOf(rows, [](const auto& r) { return r.measures.success ? 1.0 : 0.0; });
  const auto distance = [](const auto& r) { return r.measures.e_v; };
  summary.e_v = meanOf(rows, distance);
  summary.e_v_quantiles = quantilesOf(rows, distance);
  summary.e_h = meanOf(rows, [](const auto& r) { return r.measures.e_h; });
  summary.e_len = meanOf(rows, [](const auto& r) { return r.measures.e_len; });
  summary.e_com = meanOf(rows, [](const auto& r) { return r.measures.e_com; });
  summary.milliseconds =
      meanOf(rows, [](const auto& r) { return r.feature_ms + r.reconstruction_ms; });
  return summary;
}

/** \brief The geometry, or the family of random shapes and its dimensions. */
std::string
shapeOf(const BenchmarkRun& run)
{
  return run.random ? std::string(nameOf(run.random->family)) +
                          (run.random->flat ? "-2d" : "-3d")
                    : std::string(nameOf(run.geometry));
}

std::string
oneDigit(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

std::string
noiseRateInterval(const BenchmarkRow& row)
{
  const double low = std::floor(row.noise_rate * 10) / 10;
  return std::isfinite(low) ? oneDigit(low) + " - " + oneDigit(low + 0.1) : "unknown";
}

void
addLine(std::string& table, const std::string& name, const RunSummary& summary)
{
  char text[160];
  std::snprintf(text,
                sizeof text,
                "  %-14s %7zu  %7.3f  %6.3f  %6.3f  %6.3f  %6.3f  %7.1f\n",
                name.c_str(),
                summary.runs,
                summary.success,
                summary.e_v,
                summary.e_h,
                summary.e_len,
                summary.e_com,
                summary.milliseconds);
  table += text;
}

} // namespace

double
RunSummary::standardError() const
{
  if (runs < 2)
    return std::numeric_limits<double>::quiet_NaN();
  return std::sqrt(success * (1 - success) / static_cast<double>(runs - 1));
}

RunSummary
summarize(const std::vector<BenchmarkRow>& rows)
{
  Rows all;
  for (const BenchmarkRow& row : rows)
    all.push_back(&row);
  return summaryOf(all);
}

std::vector<SummaryGroup>
summarizeByProperty(const std::vector<BenchmarkRow>& rows)
{
  using Name = std::string (*)(const BenchmarkRow&);
  std::vector<std::pair<const char*, Name>> properties = {
      {"geometry", [](const auto& r) { return shapeOf(r.run); }},
      {"points", [](const auto& r) { return std::to_string(r.run.sampling.points); }},
      {"S_D", [](const auto& r) { return oneDigit(r.run.sampling.distribution); }},
      {"S_J", [](const auto& r) { return oneDigit(r.run.sampling.jitter); }},
      {"M / N",
       [](const auto& r) {
         return oneDigit(static_cast<double>(r.run.sampling.outliers) /
                         static_cast<double>(r.run.sampling.points));
       }},
      {"n_R", noiseRateInterval}};
  if (std::all_of(rows.begin(), rows.end(), [](const auto& r) { return r.run.random; }))
    properties.push_back({"noise", [](const auto& r) {
                            return std::string(nameOf(r.run.random->noise));
                          }});

  std::vector<SummaryGroup> groups;
  for (const auto& [title, nameOfRow] : properties) {
    std::vector<std::string> order;
    std::map<std::string, Rows> rows_of;
    for (const BenchmarkRow& row : rows) {
      Rows& same = rows_of[nameOfRow(row)];
      if (same.empty())
        order.push_back(nameOfRow(row));
      same.push_back(&row);
    }
    SummaryGroup group;
    group.title = title;
    // Sorting as text sorts by size: numbers of points have three digits.
    if (group.title != "geometry")
      std::sort(order.begin(), order.end());
    for (const std::string& name : order)
      group.entries.emplace_back(name, summaryOf(rows_of[name]));
    groups.push_back(group);
  }
  return groups;
}

std::string
summaryTable(const std::vector<BenchmarkRow>& rows)
{
  std::string table =
      "                    runs  success     E_V     E_H   E_Len   E_Com       ms\n";
  if (rows.empty())
    return table;
  addLine(table, "all", summarize(rows));
  for (const SummaryGroup& group : summarizeByProperty(rows)) {
    table += group.title + "\n";
    for (const auto& [name, summary] : group.entries)
      addLine(table, name, summary);
  }
  return table;
}

} // namespace linelet::bench
