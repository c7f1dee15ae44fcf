// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstdint>

#include "symbol_search.h"

namespace linelet::laz {

// Adaptive models of the arithmetic coder (A. Said, FastAC, 2004), as defined by LAZ.

constexpr unsigned symbol_bits = 15; ///< probabilities of symbols are in units of 2^-15
constexpr unsigned bit_bits = 13;    ///< those of bits in units of 2^-13

/** \brief The probability that a bit is 0. */
class BitModel {
public:
  std::uint32_t
  probability() const
  {
    return probability_;
  }

  void
  count(unsigned bit)
  {
    zeros_ += 1 - bit;
    if (--until_ == 0)
      update();
  }

private:
  void
  update()
  {
    if ((total_ += cycle_) > (1U << bit_bits)) {
      total_ = (total_ + 1) / 2;
      zeros_ = (zeros_ + 1) / 2;
      if (zeros_ == total_)
        ++total_;
    }
    probability_ = (zeros_ * (0x80000000U / total_)) >> (31 - bit_bits);
    until_ = cycle_ = std::min(5 * cycle_ / 4, 64U);
  }

  std::uint32_t zeros_ = 1, total_ = 2;
  std::uint32_t probability_ = 1U << (bit_bits - 1);
  std::uint32_t cycle_ = 4, until_ = 4;
};

/** \brief The probabilities of at most \a N symbols. */
template <unsigned N>
class SymbolModel {
public:
  explicit SymbolModel(unsigned symbols = N) : last_(symbols - 1)
  {
    std::fill_n(counts_, symbols, std::uint16_t{1});
    std::fill_n(counts_ + symbols, room - symbols, std::uint16_t{0});
    std::fill_n(low_, room, std::int16_t{0x7FFF});
    std::fill_n(coarse_, groups_room, std::int16_t{0x7FFF});
    cycle_ = symbols;
    update();
    until_ = cycle_ = (symbols + 6) / 2;
  }

  /** \brief The last symbol whose interval begins at or before \a target. */
  unsigned
  find(std::uint32_t target) const
  {
    const auto limit =
        static_cast<std::int16_t>(std::min<std::uint32_t>(target, 0x7FFF));
    if constexpr (N <= 64)
      return std::min(lastAtMost<N>(low_, limit), last_);
    else {
      const unsigned group = lastAtMost<groups>(coarse_, limit);
      return std::min(16 * group + lastAtMost<16>(low_ + 16 * group, limit), last_);
    }
  }

  /** \brief Start of the interval of \a symbol, in units of 2^-15. */
  std::uint32_t
  low(unsigned symbol) const
  {
    return static_cast<std::uint16_t>(low_[symbol]);
  }

  unsigned
  last() const
  {
    return last_;
  }

  void
  count(unsigned symbol)
  {
    ++counts_[symbol];
    if (--until_ == 0)
      update();
  }

private:
  static constexpr unsigned groups = (N + 15) / 16;
  static constexpr unsigned room = 16 * groups;
  static constexpr unsigned groups_room = 16 * ((groups + 15) / 16);

  __attribute__((noinline)) void
  update()
  {
    const unsigned symbols = last_ + 1;
    if ((total_ += cycle_) > (1U << symbol_bits)) {
      total_ = 0;
      for (unsigned i = 0; i < symbols; ++i)
        total_ += counts_[i] = static_cast<std::uint16_t>((counts_[i] + 1U) / 2);
    }
    const std::uint32_t scale = 0x80000000U / total_;
    std::uint32_t sum = 0;
    for (unsigned i = 0; i < symbols; ++i) {
      low_[i] = static_cast<std::int16_t>((scale * sum) >> (31 - symbol_bits));
      sum += counts_[i];
    }
    for (unsigned i = 0; i < (symbols + 15) / 16; ++i)
      coarse_[i] = low_[16 * i];
    until_ = cycle_ = std::min(5 * cycle_ / 4, 8 * (symbols + 6));
  }

  alignas(16) std::int16_t coarse_[groups_room]; ///< every 16th of low_
  alignas(16) std::int16_t low_[room];           ///< starts of the intervals
  std::uint16_t counts_[room];
  unsigned last_;
  std::uint32_t total_ = 0, cycle_ = 0, until_ = 0;
};

} // namespace linelet::laz
