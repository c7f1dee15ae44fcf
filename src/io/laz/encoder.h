// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "models.h"

namespace linelet::laz {

/** \brief Arithmetic encoder into memory. Calls return the value they were given; see
 * \ref Decoder. */
class Encoder {
public:
  static constexpr bool encodes = true;

  template <unsigned N>
  unsigned
  symbol(SymbolModel<N>& model, unsigned value)
  {
    const std::uint32_t unit = length_ >> symbol_bits;
    const std::uint32_t low = model.low(value) * unit;
    const std::uint32_t high =
        value == model.last() ? length_ : model.low(value + 1) * unit;
    narrow(low, high - low);
    model.count(value);
    return value;
  }

  unsigned
  bit(BitModel& model, unsigned value)
  {
    const std::uint32_t border = model.probability() * (length_ >> bit_bits);
    if (value == 0)
      narrow(0, border);
    else
      narrow(border, length_ - border);
    model.count(value);
    return value;
  }

  std::uint32_t
  bits(unsigned count, std::uint32_t value)
  {
    if (count > 19) {
      bits(16, value & 0xFFFFU);
      bits(count - 16, value >> 16U);
      return value;
    }
    const std::uint32_t unit = length_ >> count;
    narrow(value * unit, unit);
    return value;
  }

  std::uint32_t
  word(std::uint32_t value)
  {
    bits(16, value & 0xFFFFU);
    bits(16, value >> 16U);
    return value;
  }

  /** \brief Ends the stream such that a decoder has read exactly its bytes after the
   * last value, and returns it. */
  std::vector<std::uint8_t>
  finish()
  {
    const bool wide = length_ > 2 * least_length;
    if (wide)
      narrow(least_length, least_length / 2);
    else
      narrow(least_length / 2, least_length >> 9U);
    bytes_.insert(bytes_.end(), wide ? 3 : 2, std::uint8_t{0});
    return std::move(bytes_);
  }

private:
  static constexpr std::uint32_t least_length = 1U << 24U;

  /** Narrows the interval to its part of length \a length that starts at \a low. */
  void
  narrow(std::uint32_t low, std::uint32_t length)
  {
    base_ += low;
    if (base_ < low)
      carry();
    length_ = length;
    while (length_ < least_length) {
      bytes_.push_back(static_cast<std::uint8_t>(base_ >> 24U));
      base_ <<= 8U;
      length_ <<= 8U;
    }
  }

  void
  carry()
  {
    std::size_t i = bytes_.size();
    while (++bytes_[--i] == 0) {
    }
  }

  std::vector<std::uint8_t> bytes_;
  std::uint32_t base_ = 0, length_ = 0xFFFFFFFFU;
};

} // namespace linelet::laz
