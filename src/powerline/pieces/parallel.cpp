// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/parallel.h"

#include <algorithm>
#include <cmath>

#include "powerline/pieces/span_model.h"

namespace linelet::powerline {

namespace {

constexpr double least_cosine = 0.99; // between parallel wires

} // namespace

Parallel
compare(const SpanModel& a, const SpanModel& b)
{
  Parallel result;
  if (std::abs(a.direction.dot(b.direction)) < least_cosine)
    return result;
  const double from = a.along(b.at(b.begin)), to = a.along(b.at(b.end));
  const double low = std::max(a.begin, std::min(from, to));
  const double high = std::min(a.end, std::max(from, to));
  if (high <= low)
    return result;
  result.overlap = high - low;
  const int steps = 5;
  for (int k = 0; k < steps; ++k)
    result.distance += b.distance(a.at(low + (k + 0.5) / steps * (high - low))) / steps;
  return result;
}

} // namespace linelet::powerline
