// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>

namespace linelet::bench {

/** \brief Wall time and processor time in seconds, the minimum of several runs each. */
struct BestTime {
  double wall = std::numeric_limits<double>::infinity();
  double cpu = std::numeric_limits<double>::infinity();

  /** \brief Runs \a work once. */
  template <class Work>
  void
  run(Work&& work)
  {
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t cpu_begin = std::clock();
    work();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    wall = std::min(wall, took.count());
    cpu = std::min(cpu, static_cast<double>(std::clock() - cpu_begin) / CLOCKS_PER_SEC);
  }
};

} // namespace linelet::bench
