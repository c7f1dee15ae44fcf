// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "weight_table.h"

#include <algorithm>
#include <cmath>

#include "weight_error.h"

namespace linelet::grid {

namespace {

constexpr std::size_t most_terms = WeightTable::most_degree + 1;
using Series = std::array<double, most_terms>;

// The first intervals may be left to the functions themselves.
constexpr std::size_t most_left_out = 2;

/** \brief Whether the functions themselves cost more than a table. */
bool
isCostly(Kernel kernel)
{
  switch (kernel) {
  case Kernel::FermiDirac1:
  case Kernel::FermiDirac2:
  case Kernel::FermiDirac3:
  case Kernel::FermiDirac:
    return true;
  default:
    return false;
  }
}

/** \brief The polynomial in t, |t| <= 1/2, that agrees with \a f at the Chebyshev
 * nodes. */
template <class Function>
Series
interpolate(const Function& f, std::size_t terms)
{
  Series values{}, chebyshev{};
  const auto angle = [&](std::size_t node) {
    return M_PI * (static_cast<double>(node) + 0.5) / static_cast<double>(terms);
  };
  for (std::size_t node = 0; node < terms; ++node)
    values[node] = f(std::cos(angle(node)) / 2);
  for (std::size_t k = 0; k < terms; ++k) {
    for (std::size_t node = 0; node < terms; ++node)
      chebyshev[k] += values[node] * std::cos(static_cast<double>(k) * angle(node));
    chebyshev[k] *= (k == 0 ? 1.0 : 2.0) / static_cast<double>(terms);
  }
  // From Chebyshev polynomials of 2t to powers of t, by their recurrence.
  Series before{}, current{}, powers{};
  before[0] = 1;
  current[1] = 2;
  powers[0] = chebyshev[0];
  for (std::size_t k = 1; k < terms; ++k) {
    Series next{};
    for (std::size_t i = 0; i < terms; ++i) {
      powers[i] += chebyshev[k] * current[i];
      next[i] = (i > 0 ? 4 * current[i - 1] : 0) - before[i];
    }
    before = current;
    current = next;
  }
  return powers;
}

} // namespace

WeightTable::WeightTable(const Weighting& weighting)
{
  if (!isCostly(weighting.kernel()))
    return;
  for (int candidate = least_degree; candidate <= most_degree; ++candidate)
    if (fit(weighting, candidate)) {
      degree = candidate;
      return;
    }
}

bool
WeightTable::fit(const Weighting& weighting, int with_degree)
{
  const auto terms = static_cast<std::size_t>(with_degree) + 1;
  const WeightError allowed = weightError(weighting);
  const auto argument = [](std::size_t interval, double t) {
    return std::max(0.0, (static_cast<double>(interval) + 0.5 + t) / intervals);
  };
  const double relative = std::min(allowed.relative, 1e-6);
  coefficients = {};
  std::size_t first = 0; // interval that is accurate enough, as are all after it
  for (std::size_t interval = 0; interval < intervals; ++interval) {
    const auto w = [&](double t) {
      return weighting(std::sqrt(argument(interval, t)));
    };
    const Series series = interpolate(w, terms);
    double power = 1;
    for (std::size_t i = 0; i < terms; ++i, power *= intervals)
      coefficients[i][interval] = static_cast<float>(series[i] * power);
    constexpr int samples = 24;
    for (int sample = 0; sample <= samples && first <= interval; ++sample) {
      const double t = static_cast<double>(sample) / samples - 0.5;
      double value = 0;
      for (std::size_t i = terms; i-- > 0;)
        value = value * t + series[i];
      const double exact = w(t);
      if (!(std::abs(value - exact) <= (allowed.absolute + relative * exact) / 2))
        first = interval + 1;
    }
    if (first > most_left_out)
      return false;
  }
  // The border itself may be rounded into the interval below it.
  from = static_cast<float>(first) / intervals * 1.000001F;
  return true;
}

} // namespace linelet::grid
