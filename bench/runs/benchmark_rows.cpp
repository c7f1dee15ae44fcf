// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <bench/runs/benchmark.h>

#include <cmath>
#include <cstdio>
#include <istream>
#include <ostream>
#include <sstream>
#include <stdexcept>

namespace linelet::bench {

namespace {

std::string
format(const char* pattern, double value)
{
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

/** \brief What \ref shapeName gives that name. */
void
setShape(BenchmarkRun& run, const std::string& name)
{
  run.random = randomCloudKind(name);
  if (!run.random)
    run.geometry = fromName<Geometry>(name);
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
  key << method << ',' << shapeName(run) << ',' << s.points << ','
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
      setShape(row.run, fields[1]);
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
      continue; // not a row
    }
  }
  return rows;
}

} // namespace linelet::bench
