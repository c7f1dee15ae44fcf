// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// The scene matrix: curves and power lines compared with the truth, row by row.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include <bench/measures/scene_scores.h>
#include <bench/scenes/scene.h>
#include <linelet/curves/reconstruct_curves.h>
#include <linelet/powerline/extract_power_lines.h>

namespace {

using namespace linelet;
using namespace linelet::bench;

constexpr std::uint32_t first_final_seed = 1000;

constexpr const char* usage =
    R"(usage: benchmark_scenes [--rows NAME,...] [--seeds FIRST COUNT=1 2]
           [--methods NAME,...] [--json FILE] [--final]

Curves and power lines of simulated scenes against the truth, row by row.

Rows are the scenes of `linelet generate scene`; all without --rows. Methods: curves
(everything above ground by the true classes), curves-ground (the whole cloud),
powerlines (the whole cloud, classes not told). Seeds 1 to 99 are for development; those
of 1000 and more are for final figures, drawn once at the end, and need --final.
)";

struct Request {
  std::vector<SceneKind> rows;
  std::vector<std::string> methods{"curves", "curves-ground", "powerlines"};
  std::uint32_t first = 1, count = 2;
  std::string json;
  bool final = false;
};

std::vector<std::string>
split(const std::string& list)
{
  std::vector<std::string> parts;
  std::istringstream stream(list);
  for (std::string part; std::getline(stream, part, ',');)
    parts.push_back(part);
  return parts;
}

Request
readRequest(const std::vector<std::string>& words)
{
  Request request;
  std::size_t i = 0;
  const auto next = [&]() -> const std::string& {
    if (i + 1 >= words.size())
      throw std::invalid_argument(words[i] + " needs a value");
    return words[++i];
  };
  for (; i < words.size(); ++i) {
    if (words[i] == "--rows")
      for (const std::string& name : split(next()))
        request.rows.push_back(fromName<SceneKind>(name));
    else if (words[i] == "--seeds") {
      request.first = static_cast<std::uint32_t>(std::stoul(next()));
      request.count = static_cast<std::uint32_t>(std::stoul(next()));
    }
    else if (words[i] == "--methods")
      request.methods = split(next());
    else if (words[i] == "--json")
      request.json = next();
    else if (words[i] == "--final")
      request.final = true;
    else
      throw std::invalid_argument("there is no option " + words[i]);
  }
  for (const std::string& method : request.methods)
    if (method != "curves" && method != "curves-ground" && method != "powerlines")
      throw std::invalid_argument("there is no method " + method);
  if (request.rows.empty())
    for (const auto& entry : Names<SceneKind>::table)
      request.rows.push_back(entry.first);
  if (request.first + request.count > first_final_seed && !request.final)
    throw std::invalid_argument(
        "seeds of 1000 and more are for final figures: --final, or smaller seeds");
  return request;
}

/** One method over the seeds of a row. */
struct Result {
  SceneScores scores;
  double seconds = 0;
  std::size_t points = 0;

  Result&
  operator+=(const Result& other)
  {
    scores += other.scores;
    seconds += other.seconds;
    points += other.points;
    return *this;
  }
};

class Stopwatch {
public:
  double
  seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_)
        .count();
  }

private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

Result
runCurves(const SceneScan& scan, bool ground)
{
  constexpr std::uint8_t ground_class = 2;
  Points points;
  for (std::size_t i = 0; i < scan.points.size(); ++i)
    if (ground || scan.classification[i] != ground_class)
      points.push_back(scan.points[i]);
  Result result;
  result.points = points.size();
  const Stopwatch watch;
  const CurveNetwork found = reconstructCurves(points);
  result.seconds = watch.seconds();
  result.scores = scoreSceneCurves(found, scan);
  return result;
}

Result
runPowerLines(const SceneScan& scan, std::vector<CalibrationBin>& bins)
{
  Result result;
  result.points = scan.points.size();
  const Stopwatch watch;
  const powerline::PowerLineNetwork network = powerline::extractPowerLines(scan.points);
  result.seconds = watch.seconds();
  CurveNetwork found;
  std::vector<double> confidence;
  for (const powerline::Wire& wire : network.wires) {
    Curve curve;
    curve.points = polyline(wire);
    found.curves.push_back(std::move(curve));
    confidence.push_back(wire.confidence);
  }
  result.scores = scoreSceneWires(found, scan);
  calibrate(found, confidence, scan, bins);
  return result;
}

std::string
share(double value)
{
  if (!std::isfinite(value))
    return "    -";
  char text[16];
  std::snprintf(text, sizeof text, "%5.3f", value);
  return text;
}

void
print(const std::string& row,
      const std::string& seed,
      const std::string& method,
      const Result& r)
{
  std::printf("%-14s %-5s %-13s %8zu %s %s %8.0f %8.0f %8.1f\n",
              row.c_str(),
              seed.c_str(),
              method.c_str(),
              r.points,
              share(r.scores.recall()).c_str(),
              share(r.scores.precision()).c_str(),
              r.scores.true_length,
              r.scores.falseLength(),
              r.seconds);
  std::fflush(stdout);
}

nlohmann::ordered_json
toJson(const std::string& row,
       const std::string& seed,
       const std::string& method,
       const Result& r)
{
  return {{"row", row},
          {"seed", seed},
          {"method", method},
          {"points", r.points},
          {"true_length", r.scores.true_length},
          {"covered_length", r.scores.covered_length},
          {"found_length", r.scores.found_length},
          {"right_length", r.scores.right_length},
          {"seconds", r.seconds}};
}

void
printCalibration(const std::vector<CalibrationBin>& bins)
{
  std::printf("\nconfidence of power line wires\n  from    to  wires  said  true\n");
  for (const CalibrationBin& bin : bins)
    if (bin.wires > 0)
      std::printf(" %5.2f %5.2f %6zu %s %s\n",
                  bin.from,
                  bin.to,
                  bin.wires,
                  share(bin.confidence_sum / static_cast<double>(bin.wires)).c_str(),
                  share(static_cast<double>(bin.right) / static_cast<double>(bin.wires))
                      .c_str());
}

void
runMatrix(const Request& request)
{
  std::vector<CalibrationBin> bins;
  for (int i = 0; i < 10; ++i)
    bins.push_back({0.1 * i, 0.1 * (i + 1), 0, 0, 0});
  auto all = nlohmann::ordered_json::array();
  std::printf(
      "row            seed  method          points recall prec.  true m  false m "
      "       s\n");
  for (const SceneKind kind : request.rows) {
    const std::string row(nameOf(kind));
    std::vector<Result> sums(request.methods.size());
    for (std::uint32_t k = 0; k < request.count; ++k) {
      SceneSettings settings;
      settings.kind = kind;
      settings.seed = request.first + k;
      const SceneScan scan = simulateScene(settings);
      for (std::size_t m = 0; m < request.methods.size(); ++m) {
        const std::string& method = request.methods[m];
        const Result result = method == "powerlines"
                                  ? runPowerLines(scan, bins)
                                  : runCurves(scan, method == "curves-ground");
        const std::string seed = std::to_string(settings.seed);
        print(row, seed, method, result);
        all.push_back(toJson(row, seed, method, result));
        sums[m] += result;
      }
    }
    if (request.count > 1)
      for (std::size_t m = 0; m < sums.size(); ++m)
        print(row, "all", request.methods[m], sums[m]);
  }
  printCalibration(bins);
  if (!request.json.empty()) {
    std::ofstream file(request.json);
    file << all.dump(1) << '\n';
    if (!file.flush())
      throw std::runtime_error("cannot write " + request.json);
  }
}

} // namespace

int
main(int count, char** arguments)
{
  try {
    const std::vector<std::string> words(arguments + 1, arguments + count);
    if (std::find(words.begin(), words.end(), "--help") != words.end()) {
      std::printf("%s", usage);
      return EXIT_SUCCESS;
    }
    runMatrix(readRequest(words));
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error) {
    std::fprintf(stderr, "scenes: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
