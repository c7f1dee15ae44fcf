// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scenes.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <map>
#include <tuple>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

namespace linelet::benchmarking {

namespace {

Points
make(Scene scene, std::size_t count, Order order)
{
  boost::random::mt19937 random(1);
  boost::random::uniform_real_distribution<double> unit(0, 1);
  const auto n = static_cast<double>(count);
  const double edge = scene == Scene::Volume ? std::cbrt(n) : std::sqrt(n);
  Points points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = edge * unit(random), y = edge * unit(random), z = unit(random);
    points.emplace_back(
        x, y, scene == Scene::Volume ? edge * z : 3 * std::sin(x / 40) + 0.1 * z);
  }
  if (order == Order::Sorted) {
    // Scan lines 4 units wide, side by side.
    const auto line = [](const Point& p) { return std::floor(p.y() / 4); };
    std::sort(points.begin(), points.end(), [&](const Point& a, const Point& b) {
      return std::make_tuple(line(a), a.x()) < std::make_tuple(line(b), b.x());
    });
  }
  return points;
}

} // namespace

const Points&
scene(Scene scene, std::size_t count, Order order)
{
  // One at a time, since the largest take hundreds of megabytes.
  static std::tuple<Scene, std::size_t, Order> last;
  static Points points;
  if (points.empty() || last != std::make_tuple(scene, count, order)) {
    points = make(scene, count, order);
    last = {scene, count, order};
  }
  return points;
}

double
radiusFor(Scene scene, double neighbors)
{
  return scene == Scene::Volume ? std::cbrt(neighbors * 3 / (4 * M_PI))
                                : std::sqrt(neighbors / M_PI);
}

double
cpuSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

double
seconds(unsigned threads)
{
  if (threads == 1)
    return cpuSeconds();
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

} // namespace linelet::benchmarking
