// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Times the default reconstruction on large clouds, including clouds without any curve.
//   benchmark_large_clouds [POINTS [THREADS [CLOUD...]]]
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <sys/resource.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <bench/geometries/geometries.h>
#include <bench/geometries/test_cloud.h>
#include <bench/measures/measures.h>
#include <linelet/curves/refined_reconstruction.h>

using namespace linelet;

namespace {

constexpr std::size_t curves_in_cloud = 200;

using Draw = std::function<double()>; // uniform in [-1, 1]

/** \brief 200 wires, helices, waves and circles side by side, 2 % outliers each. */
Points
manyCurves(std::size_t count, double jitter, double distance, CurveNetwork* truth)
{
  using bench::Geometry;
  const Geometry shapes[] = {
      Geometry::Line, Geometry::Helix, Geometry::Wave, Geometry::Circle};
  Points points;
  for (std::size_t c = 0; c < curves_in_cloud; ++c) {
    bench::SamplingSettings settings;
    settings.points = count / curves_in_cloud;
    settings.jitter = jitter;
    settings.distribution = 1;
    settings.outliers = settings.points / 50;
    settings.seed = c + 1;
    const Point place(distance * static_cast<double>(c % 20),
                      distance * static_cast<double>(c / 20),
                      0);
    for (const Point& p : bench::sample(shapes[c % 4], settings))
      points.push_back(p + place);
    for (Curve curve : bench::truthOf(shapes[c % 4]).curves) {
      for (Point& p : curve.points)
        p += place;
      truth->curves.push_back(std::move(curve));
    }
  }
  return points;
}

Points
filled(std::size_t count, const std::function<bool(Point&)>& shape, const Draw& draw)
{
  Points points;
  while (points.size() < count) {
    Point p(draw(), draw(), draw());
    if (shape(p))
      points.push_back(p);
  }
  return points;
}

} // namespace

int
main(int argument_count, char** arguments)
{
  const auto count =
      static_cast<std::size_t>(argument_count > 1 ? std::atof(arguments[1]) : 1e6);
  RefinedSettings settings;
  settings.threads =
      argument_count > 2 ? static_cast<unsigned>(std::atoi(arguments[2])) : 0;
  boost::random::mt19937 random(1);
  boost::random::uniform_real_distribution<double> uniform(-1, 1);
  const Draw draw = [&] { return uniform(random); };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();

  CurveNetwork truth;
  const std::vector<std::pair<std::string, std::function<Points()>>> clouds = {
      {"curves", [&] { return manyCurves(count, 0.1, 20, &truth); }},
      {"clean-curves", [&] { return manyCurves(count, 0, 20, &truth); }},
      {"noisy-curves", [&] { return manyCurves(count, 0.4, 20, &truth); }},
      {"linked-curves", [&] { return manyCurves(count, 0.1, 10.5, &truth); }},
      {"huge-coordinates",
       [&] {
         Points points = manyCurves(count, 0.1, 20, &truth);
         for (Curve& curve : truth.curves)
           for (Point& p : curve.points)
             p += Point(5e6, -5e6, 1e3);
         for (Point& p : points)
           p += Point(5e6, -5e6, 1e3);
         return points;
       }},
      {"cube",
       [&] {
         return filled(
             count, [](Point&) { return true; }, draw);
       }},
      {"ball",
       [&] {
         return filled(
             count, [](Point& p) { return p.norm() < 1; }, draw);
       }},
      {"plane",
       [&] {
         return filled(
             count,
             [](Point& p) {
               p.z() = 0.3 * p.x();
               return true;
             },
             draw);
       }},
      {"line",
       [&] {
         return filled(
             count,
             [](Point& p) {
               p = Point(p.x(), 0.5 * p.x(), 1);
               return true;
             },
             draw);
       }},
      {"coincident", [&] { return Points(count, Point(1, 2, 3)); }},
      {"not-a-number", [&] { return Points(count, Point(nan, nan, nan)); }}};

  std::printf("| cloud | points | s | CPU s | peak MB so far | curves | length | E_Len "
              "| E_Com | "
              "E_V |\n|---|---|---|---|---|---|---|---|---|---|\n");
  for (const auto& [name, make] : clouds) {
    bool wanted = argument_count <= 3;
    for (int k = 3; k < argument_count; ++k)
      wanted = wanted || name == arguments[k];
    if (!wanted)
      continue;
    truth.curves.clear();
    const Points points = make();
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t work = std::clock();
    const CurveNetwork result = reconstructRefined(points, settings);
    const std::chrono::duration<double> taken =
        std::chrono::steady_clock::now() - begin;
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    std::printf("| %s | %zu | %.2f | %.2f | %ld | %zu | %.6g |",
                name.c_str(),
                points.size(),
                taken.count(),
                static_cast<double>(std::clock() - work) / CLOCKS_PER_SEC,
                usage.ru_maxrss / 1024,
                result.curves.size(),
                length(result));
    if (!truth.curves.empty() && !result.curves.empty()) {
      const bench::Measures m = bench::measure(result, truth);
      std::printf(" %.3f | %.3f | %.4f |\n", m.e_len, m.e_com, m.e_v);
    }
    else
      std::printf(" | | |\n");
    std::fflush(stdout);
  }
  return 0;
}
