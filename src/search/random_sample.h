// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <utility>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include <linelet/support/points.h>

namespace linelet {

/** \brief Leaves a random \a sample of \a chosen (Fisher and Yates, cut short); all of
 * them if it is 0 or there are no more. */
inline void
keepRandomSample(Indices& chosen, std::size_t sample, unsigned seed)
{
  if (sample == 0 || sample >= chosen.size())
    return;
  boost::random::mt19937 random(seed);
  for (std::size_t i = 0; i < sample; ++i) {
    boost::random::uniform_int_distribution<std::size_t> rest(i, chosen.size() - 1);
    std::swap(chosen[i], chosen[rest(random)]);
  }
  chosen.resize(sample);
}

} // namespace linelet
