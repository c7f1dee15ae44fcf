// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_01.hpp>
#include <boost/random/uniform_int_distribution.hpp>

namespace linelet::bench {

constexpr double pi = 3.14159265358979323846;

/** \brief Random numbers that are the same on every machine, provided that no
 * expression draws two of them in unspecified order. */
class Random {
public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}

  double
  uniform(double low, double high)
  {
    return low + (high - low) * boost::random::uniform_01<double>()(engine_);
  }

  double
  normal(double deviation)
  {
    return deviation * boost::random::normal_distribution<double>(0, 1)(engine_);
  }

  int
  integer(int low, int high)
  {
    return boost::random::uniform_int_distribution<int>(low, high)(engine_);
  }

private:
  boost::random::mt19937 engine_;
};

} // namespace linelet::bench
