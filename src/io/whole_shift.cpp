// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/whole_shift.h>

#include <cmath>

namespace linelet::io {

double
wholeShift(double low, double high)
{
  constexpr double near_enough = 1000;
  if (!(low <= high))
    return 0;
  if (low > near_enough)
    return std::floor(low);
  return high < -near_enough ? std::ceil(high) : 0;
}

} // namespace linelet::io
