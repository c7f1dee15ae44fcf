// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/evaluation/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <istream>
#include <map>
#include <ostream>
#include <sstream>
#include <stdexcept>

namespace linelet::evaluation {

namespace {

std::string
format(const char* pattern, double value)
{
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

/** \brief Mean of what is known. */
class Mean {
public:
  void
  add(double value)
  {
    if (!std::isfinite(value))
      return;
    sum_ += value;
    ++count_;
  }

  double
  value() const
  {
    return sum_ / count_;
  }

private:
  double sum_ = 0, count_ = 0;
};

struct Group {
  std::size_t runs = 0;
  Mean success, e_v, e_h, e_len, e_com, ms;

  void
  add(const BenchmarkRow& row)
  {
    ++runs;
    success.add(row.measures.success ? 1 : 0);
    e_v.add(row.measures.e_v);
    e_h.add(row.measures.e_h);
    e_len.add(row.measures.e_len);
    e_com.add(row.measures.e_com);
    ms.add(row.feature_ms + row.reconstruction_ms);
  }
};

void
line(std::string& table, const std::string& name, const Group& group)
{
  char text[160];
  std::snprintf(text,
                sizeof text,
                "  %-14s %7zu  %7.3f  %6.3f  %6.3f  %6.3f  %6.3f  %7.1f\n",
                name.c_str(),
                group.runs,
                group.success.value(),
                group.e_v.value(),
                group.e_h.value(),
                group.e_len.value(),
                group.e_com.value(),
                group.ms.value());
  table += text;
}

} // namespace

const char* const benchmark_csv_header =
    "method,geometry,points,distribution,jitter,outliers,seed,noise_rate,e_h,e_v,e_len,"
    "e_com,success,feature_ms,reconstruction_ms";

std::string
keyOf(const std::string& method, const BenchmarkRun& run)
{
  const SamplingSettings& s = run.sampling;
  std::ostringstream key;
  key << method << ',' << nameOf(run.geometry) << ',' << s.points << ','
      << format("%.3g", s.distribution) << ',' << format("%.3g", s.jitter) << ','
      << s.outliers << ',' << s.seed;
  return key.str();
}

void
writeCsv(std::ostream& out, const BenchmarkRow& row)
{
  const Measures& m = row.measures;
  out << keyOf(row.method, row.run);
  for (const double value : {row.noise_rate, m.e_h, m.e_v, m.e_len, m.e_com})
    out << ',' << format("%.6g", value);
  out << ',' << (m.success ? 1 : 0) << ',' << format("%.3f", row.feature_ms) << ','
      << format("%.3f", row.reconstruction_ms) << '\n';
}

std::vector<BenchmarkRow>
readCsv(std::istream& in)
{
  std::string text;
  if (!std::getline(in, text) || text != benchmark_csv_header)
    throw std::runtime_error("not a file of benchmark rows: its first line must be " +
                             std::string(benchmark_csv_header));
  std::vector<BenchmarkRow> rows;
  while (std::getline(in, text)) {
    if (in.eof())
      break; // no line end: written in part
    std::vector<std::string> fields;
    std::istringstream split(text);
    for (std::string field; std::getline(split, field, ',');)
      fields.push_back(field);
    if (fields.size() != 15)
      continue;
    try {
      BenchmarkRow row;
      row.method = fields[0];
      row.run.geometry = fromName<Geometry>(fields[1]);
      row.run.sampling.points = std::stoul(fields[2]);
      row.run.sampling.distribution = std::stod(fields[3]);
      row.run.sampling.jitter = std::stod(fields[4]);
      row.run.sampling.outliers = std::stoul(fields[5]);
      row.run.sampling.seed = std::stoul(fields[6]);
      row.noise_rate = std::stod(fields[7]);
      row.measures.e_h = std::stod(fields[8]);
      row.measures.e_v = std::stod(fields[9]);
      row.measures.e_len = std::stod(fields[10]);
      row.measures.e_com = std::stod(fields[11]);
      row.measures.success = fields[12] == "1";
      row.feature_ms = std::stod(fields[13]);
      row.reconstruction_ms = std::stod(fields[14]);
      rows.push_back(row);
    }
    catch (const std::logic_error&) {
      continue; // no row
    }
  }
  return rows;
}

std::string
summaryTable(const std::vector<BenchmarkRow>& rows)
{
  using Key = std::string (*)(const BenchmarkRow&);
  const std::pair<const char*, Key> columns[] = {
      {"geometry",
       [](const BenchmarkRow& r) { return std::string(nameOf(r.run.geometry)); }},
      {"points",
       [](const BenchmarkRow& r) { return std::to_string(r.run.sampling.points); }},
      {"S_D",
       [](const BenchmarkRow& r) {
         return format("%.1f", r.run.sampling.distribution);
       }},
      {"S_J",
       [](const BenchmarkRow& r) { return format("%.1f", r.run.sampling.jitter); }},
      {"M / N",
       [](const BenchmarkRow& r) {
         return format("%.1f",
                       static_cast<double>(r.run.sampling.outliers) /
                           static_cast<double>(r.run.sampling.points));
       }},
      {"n_R", [](const BenchmarkRow& r) {
         const double low = std::floor(r.noise_rate * 10) / 10;
         return std::isfinite(low)
                    ? format("%.1f", low) + " - " + format("%.1f", low + 0.1)
                    : std::string("unknown");
       }}};

  std::string table =
      "                    runs  success     E_V     E_H   E_Len   E_Com       ms\n";
  Group all;
  for (const BenchmarkRow& row : rows)
    all.add(row);
  if (!rows.empty())
    line(table, "all", all);
  for (const auto& [title, key] : columns) {
    // Geometries in the order of the rows, numbers by size; points have three digits.
    std::vector<std::string> order;
    std::map<std::string, Group> groups;
    for (const BenchmarkRow& row : rows) {
      const std::string name = key(row);
      if (groups.count(name) == 0)
        order.push_back(name);
      groups[name].add(row);
    }
    if (std::string(title) != "geometry")
      std::sort(order.begin(), order.end());
    table += std::string(title) + "\n";
    for (const std::string& name : order)
      line(table, name, groups[name]);
  }
  return table;
}

} // namespace linelet::evaluation
