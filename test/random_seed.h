// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdlib>
#include <iostream>
#include <random>
#include <string>

namespace linelet::test {

/** \brief A seed that differs from run to run and is printed; LINELET_TEST_SEED repeats
 * a run. For tests that hold for any input: a failure is a bug, not chance. */
inline unsigned
randomSeed()
{
  const char* given = std::getenv("LINELET_TEST_SEED");
  const unsigned seed = given != nullptr
                            ? static_cast<unsigned>(std::stoul(given))
                            : static_cast<unsigned>(std::random_device()());
  std::cout << "random seed " << seed << " (LINELET_TEST_SEED=" << seed
            << " repeats it)\n";
  return seed;
}

} // namespace linelet::test
