// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Power lines extracted from simulated corridors, compared with the truth.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <bench/measures/wire_scores.h>
#include <bench/scenes/corridor.h>
#include <linelet/powerline/extract_power_lines.h>

namespace {

using namespace linelet;
using namespace linelet::bench;

constexpr const char* usage =
    R"(usage: benchmark_corridors [SCENES=6 [FIRST_SEED=1 [OPTION VALUE]...]]

Simulated corridors, extracted and compared with their truth.

OPTION is one of `linelet generate corridor`, without dashes: benchmark_corridors 5 100
voltage 380 density 10. Without options every scene takes voltage, wind, strips,
vegetation, houses and density by its seed.
)";

/** A different scene for each seed. */
CorridorSettings
sceneOf(std::uint32_t seed)
{
  CorridorSettings s;
  s.seed = seed;
  s.voltage = std::vector<double>{110, 110, 220, 380}[seed % 4];
  s.earth_wires = 1 + seed % 2;
  s.strips = 1 + seed / 2 % 2;
  s.density = std::vector<double>{20, 12, 30}[seed % 3];
  s.divergence = std::vector<double>{0.5, 0.35, 0.5, 0.8}[seed / 2 % 4];
  s.trees = std::vector<double>{30, 120, 60, 10, 200}[seed % 5];
  s.houses = seed % 4 * 4;
  s.cranes = seed % 3;
  s.low_voltage = 1 + seed % 3 / 2;
  s.relief = seed % 7 * 3;
  s.wind = seed % 5 == 0 ? 3 : 0;
  s.length = s.voltage > 200 ? 800 : 500;
  return s;
}

void
setOption(CorridorSettings& settings, const std::string& name, const std::string& value)
{
  bool known = false;
  describe(settings, [&](const char* option, auto& target, const char*) {
    using T = std::decay_t<decltype(target)>;
    if (option != name)
      return;
    known = true;
    if constexpr (std::is_enum_v<T>)
      target = fromName<T>(value);
    else
      target = static_cast<T>(std::stod(value));
  });
  if (!known)
    throw std::invalid_argument("there is no option " + name);
}

struct Scores {
  ClassScores wire, wire_away, pylon;
  WireScores vectors;
};

double
percent(double part, double whole)
{
  return whole > 0 ? 100 * part / whole : 0;
}

void
print(const std::string& name, const Scores& s, double seconds)
{
  const auto& ends = s.vectors.end_errors;
  const auto at = [&](double share) {
    return ends.empty() ? std::nan("")
                        : ends[static_cast<std::size_t>(
                              share * static_cast<double>(ends.size() - 1))];
  };
  const auto right = std::upper_bound(ends.begin(), ends.end(), 0.5) - ends.begin();
  std::printf("%-8s %.4f %.4f %.4f %7.3f | %4zu / %4zu %6.2f %6.2f %6.2f | %5.2f %5.2f "
              "%5.1f | %5.2f\n",
              name.c_str(),
              s.wire.f1(),
              s.wire_away.f1(),
              s.wire.precision(),
              s.pylon.f1(),
              s.vectors.spans_found,
              s.vectors.spans,
              percent(static_cast<double>(s.vectors.spans_found),
                      static_cast<double>(s.vectors.spans)),
              percent(s.vectors.covered_length, s.vectors.true_length),
              percent(s.vectors.false_length, s.vectors.found_length),
              at(0.5),
              at(0.95),
              percent(static_cast<double>(right), static_cast<double>(ends.size())),
              seconds);
  std::fflush(stdout);
}

Scores
run(const CorridorSettings& settings, double& seconds)
{
  const CorridorScan scan = simulateCorridor(settings);
  const auto begin = std::chrono::steady_clock::now();
  const powerline::PowerLineNetwork network = powerline::extractPowerLines(scan.points);
  seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

  CurveNetwork found;
  for (const powerline::Wire& wire : network.wires) {
    Curve curve;
    curve.points = polyline(wire);
    found.curves.push_back(std::move(curve));
  }
  Scores scores;
  const auto& truth = scan.classification;
  const auto ignored = nearClass(scan.points, truth, powerline::pylon_class, 6);
  scores.wire = scoreClass(network.classes, truth, powerline::wire_class);
  scores.wire_away = scoreClass(network.classes, truth, powerline::wire_class, ignored);
  scores.pylon = scoreClass(network.classes, truth, powerline::pylon_class);
  scores.vectors = scoreWires(found, scan.wires);
  return scores;
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
    const int scenes = words.empty() ? 6 : std::stoi(words[0]);
    const int first = words.size() < 2 ? 1 : std::stoi(words[1]);
    std::printf("scene    F1     F1away prec.  F1pylon | spans found    %%     len%%  "
                "false%% | ends: median, 95%%, %% < .5 m | s\n");
    Scores all;
    double total = 0;
    for (int k = 0; k < scenes; ++k) {
      const auto seed = static_cast<std::uint32_t>(first + k);
      CorridorSettings settings = sceneOf(seed);
      if (words.size() > 2) {
        settings = CorridorSettings{};
        settings.seed = seed;
      }
      for (std::size_t i = 2; i + 1 < words.size(); i += 2)
        setOption(settings, words[i], words[i + 1]);
      double seconds = 0;
      const Scores scores = run(settings, seconds);
      print(std::to_string(seed), scores, seconds);
      all.wire += scores.wire;
      all.wire_away += scores.wire_away;
      all.pylon += scores.pylon;
      all.vectors += scores.vectors;
      total += seconds;
    }
    print("all", all, total);
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error) {
    std::fprintf(stderr, "corridors: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
