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

ThinnedComponent
thinnedComponent(const Points& points, double size)
{
  ThinnedComponent result;
  result.share =
      std::max(1 / (size * size * size),
               static_cast<double>(least_thinned) / static_cast<double>(points.size()));
  boost::random::mt19937 random(1);
  boost::random::uniform_01<double> uniform;
  for (const Point& p : points)
    if (uniform(random) < result.share)
      result.points.push_back(p);
  return result;
}

} // namespace linelet
