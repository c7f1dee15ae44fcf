// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// benchmark_centroids prints, as Markdown tables, where the centroids lie next to a
// dense line and how long they take: 500 random points of the unit square and 216 on a
// line at y = 0 from x = .3 to .5, five seeds, each timed twice (Ritter 2025, Fig.
// 3.12).

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include <linelet/tensor/centroid.h>

using namespace linelet;

namespace {

constexpr unsigned seeds = 5;
const Point query(0.4, 0.5, 0);
constexpr double radius = 0.8; // covers the whole square

Points
scene(unsigned seed)
{
  boost::random::mt19937 random(seed);
  boost::random::uniform_real_distribution<double> uniform(0, 1);
  Points points;
  while (points.size() < 500) {
    const double x = uniform(random), y = uniform(random);
    points.emplace_back(x, y, 0);
  }
  for (int i = 0; i < 216; ++i)
    points.emplace_back(0.3 + 0.2 * i / 215, 0, 0);
  return points;
}

/** \brief Microseconds per call, averaged over as many calls as take 50 ms. */
double
timeOf(Centroid type, const Points& points)
{
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  double microseconds = 0;
  int calls = 0;
  for (double sum = 0; microseconds < 5e4; ++calls) {
    sum += centroid(type, points, query, radius).y();
    microseconds =
        std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
    if (std::isnan(sum))
      std::printf("no centroid\n");
  }
  return microseconds / calls;
}

void
printTimes()
{
  std::printf("| centroid | median µs | least | most |\n|---|---|---|---|\n");
  for (const auto& [type, name] : Names<Centroid>::table) {
    std::vector<double> times;
    for (unsigned seed = 1; seed <= seeds; ++seed)
      for (int again = 0; again < 2; ++again)
        times.push_back(timeOf(type, scene(seed)));
    std::sort(times.begin(), times.end());
    std::printf("| %s | %.2f | %.2f | %.2f |\n",
                std::string(name).c_str(),
                times[times.size() / 2],
                times.front(),
                times.back());
  }
}

void
printPlaces()
{
  std::printf("\n| m | T | weighted mean y | weighted median y |\n|---|---|---|---|\n");
  for (const double m : {0.1, 0.35, 0.7})
    for (const double t : {0.05, 0.2, 0.5}) {
      double mean = 0, median = 0;
      for (unsigned seed = 1; seed <= seeds; ++seed) {
        const Points points = scene(seed);
        const Weighting weighting = Weighting::fermiDirac(m, t);
        mean += centroid(Centroid::WeightedMean, points, query, radius, weighting).y() /
                seeds;
        median +=
            centroid(Centroid::WeightedMedian, points, query, radius, weighting).y() /
            seeds;
      }
      std::printf("| %.2f | %.2f | %.3f | %.3f |\n", m, t, mean, median);
    }
  double mean = 0, median = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    mean += centroid(Centroid::Mean, scene(seed), query, radius).y() / seeds;
    median += centroid(Centroid::Median, scene(seed), query, radius).y() / seeds;
  }
  std::printf("\nwithout weight: mean y %.3f, median y %.3f\n", mean, median);
}

} // namespace

int
main()
{
  printTimes();
  printPlaces();
  return 0;
}
