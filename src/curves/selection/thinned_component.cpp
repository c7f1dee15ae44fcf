// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "thinned_component.h"

#include <algorithm>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>

namespace linelet {

namespace {

constexpr std::size_t least_thinned = 1000;

} // namespace

EmFit
refineThinned(const Points& points,
              double size,
              const RefinedSettings& user,
              const std::function<bool()>& stop,
              const std::function<void(double)>& progress)
{
  const double share =
      std::max(1 / (size * size * size),
               static_cast<double>(least_thinned) / static_cast<double>(points.size()));
  boost::random::mt19937 random(1);
  boost::random::uniform_01<double> uniform;
  Points some;
  for (const Point& p : points)
    if (uniform(random) < share)
      some.push_back(p);
  EmFit fit = refineComponent(some, user, nullptr, stop, progress);
  for (auto& counts : fit.counts)
    for (double& count : counts)
      count /= share;
  return fit;
}

} // namespace linelet
