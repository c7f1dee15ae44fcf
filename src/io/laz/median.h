// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstdint>

namespace linelet::laz {

/** \brief An approximate median of the last differences: five of them in order, where
 * each new one replaces the largest or the smallest. */
class RunningMedian {
public:
  std::int32_t
  get() const
  {
    return values_[2];
  }

  void
  add(std::int32_t value)
  {
    const std::int32_t* kept = values_ + (drops_largest_ ? 0 : 1);
    const std::int32_t a = kept[0], b = kept[1], c = kept[2], d = kept[3];
    drops_largest_ = drops_largest_ ? value < values_[2] : value <= values_[2];
    values_[0] = std::min(a, value);
    values_[1] = std::max(a, std::min(b, value));
    values_[2] = std::max(b, std::min(c, value));
    values_[3] = std::max(c, std::min(d, value));
    values_[4] = std::max(d, value);
  }

private:
  std::int32_t values_[5] = {};
  bool drops_largest_ = true;
};

} // namespace linelet::laz
