// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// The public cases of 2D curve reconstruction: errors and times compared with those of
// FitConnect and StretchDenoise, measured on one machine and published with the data.
//   benchmark_public_cases FOLDER [published]    by the default or published method
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <bench/measures/measures.h>
#include <linelet/curves/refined_reconstruction.h>
#include <linelet/curves/streamline_reconstruction.h>

using namespace linelet;

namespace {

struct Peer {
  double milliseconds, e_v; // E_V in hundredths; NaN: fails
};
struct Case {
  const char* name;
  Peer fit_connect, stretch_denoise;
};

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const std::vector<Case> cases = {{"monitor", {1175, 0.17}, {1176, 0.19}},
                                 {"circle_0.1r", {0.8, 1.22}, {1.0, 0.86}},
                                 {"circle_0.25r", {2.8, 2.28}, {3.1, 1.87}},
                                 {"circle_0.5r", {4.7, 4.05}, {4.8, 3.96}},
                                 {"circle_0.75r", {10.4, 5.13}, {10.5, 5.45}},
                                 {"circle_1.0r", {14.3, 7.61}, {14.5, 6.49}},
                                 {"bunny_rho0.43_n0.333", {0.8, 397}, {1.5, 313}},
                                 {"bunny_eps0.2", {1.6, 465}, {2.7, 362}},
                                 {"bunny_eps0.1", {17.4, 271}, {19.6, 165}},
                                 {"bunny_eps0.1_n0", {5.5, 9.36}, {7.7, 9.36}},
                                 {"spiral", {13.4, 4.85}, {nan, nan}},
                                 {"tcrossing", {1.7, 4.65}, {nan, nan}},
                                 {"sharpcorner", {9.3, 1.29}, {9.4, 1.47}},
                                 {"stair", {33, 0.57}, {33, 0.33}},
                                 {"leafline", {1.3, 1.24}, {nan, nan}},
                                 {"features_0.05", {3.7, 1.74}, {nan, nan}}};

Points
readPoints(const std::string& file)
{
  std::ifstream in(file);
  Points points;
  for (double x, y; in >> x >> y;)
    points.emplace_back(x, y, 0);
  return points;
}

CurveNetwork
readTruth(const std::string& file)
{
  std::ifstream in(file);
  Points vertices;
  CurveNetwork network;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      Point p = Point::Zero();
      words >> p.x() >> p.y() >> p.z();
      vertices.push_back(p);
    }
    else if (kind == "l") {
      Curve curve;
      for (std::size_t i = 0; words >> i;)
        curve.points.push_back(vertices.at(i - 1));
      if (curve.points.size() > 2 && curve.points.front() == curve.points.back()) {
        // These files list an open curve back and forth.
        const std::size_t half = curve.points.size() / 2;
        if (std::equal(curve.points.begin(),
                       curve.points.begin() + static_cast<std::ptrdiff_t>(half),
                       curve.points.rbegin()))
          curve.points.resize(half + 1);
        else {
          curve.points.pop_back();
          curve.closed = true;
        }
      }
      network.curves.push_back(std::move(curve));
    }
  }
  return network;
}

} // namespace

int
main(int count, char** arguments)
{
  const bool published = count == 3 && std::string(arguments[2]) == "published";
  if (count != 2 && !published) {
    std::fprintf(stderr, "usage: benchmark_public_cases FOLDER [published]\n");
    return 2;
  }
  const std::string folder = arguments[1];
  RefinedSettings refined;
  StreamlineSettings streamlines;
  refined.threads = streamlines.threads = 1;
  std::printf(
      "| case | points | ms | E_H | E_V | E_Len %% | E_Com %% | curves | FitConnect "
      "ms, E_V | StretchDenoise ms, E_V "
      "|\n|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Case& c : cases) {
    const Points points = readPoints(folder + "/" + c.name + ".xy");
    const CurveNetwork truth = readTruth(folder + "/" + c.name + ".truth.obj");
    if (points.empty() || truth.curves.empty()) {
      std::fprintf(stderr, "%s: not found in %s\n", c.name, folder.c_str());
      return 1;
    }
    CurveNetwork result;
    double best = std::numeric_limits<double>::infinity();
    for (int run = 0; run < 5; ++run) {
      const auto begin = std::chrono::steady_clock::now();
      result = published ? reconstructPublished(points, streamlines)
                         : reconstructRefined(points, refined);
      const std::chrono::duration<double, std::milli> taken =
          std::chrono::steady_clock::now() - begin;
      best = std::min(best, taken.count());
    }
    // Scales of the measures for an extent of 10.
    Point low = points[0], high = points[0];
    for (const Point& p : points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const double unit = (high - low).maxCoeff() / 10;
    bench::MeasureSettings measures;
    measures.step = 0.01 * unit;
    measures.reach = 0.5 * unit;
    const bench::Measures m = bench::measure(result, truth, measures);
    std::printf(
        "| %s | %zu | %.2f | %.2f | %.2f | %.1f | %.0f | %zu | %.1f, %.2f | %.1f, "
        "%.2f |\n",
        c.name,
        points.size(),
        best,
        100 * m.e_h,
        100 * m.e_v,
        100 * m.e_len,
        100 * m.e_com,
        result.curves.size(),
        c.fit_connect.milliseconds,
        c.fit_connect.e_v,
        c.stretch_denoise.milliseconds,
        c.stretch_denoise.e_v);
  }
  return 0;
}
