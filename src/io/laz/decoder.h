// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "models.h"

namespace linelet::laz {

/** \brief Arithmetic decoder of a stream in memory.
 *
 * It has the interface of \ref Encoder, so that one description serves both directions:
 * it returns the values that the encoder was given. Bytes past the end read as zeros;
 * see \ref overrun. */
class Decoder {
public:
  static constexpr bool encodes = false;

  Decoder(const std::uint8_t* begin, const std::uint8_t* end) : next_(begin), end_(end)
  {
    for (int i = 0; i < 4; ++i)
      value_ = value_ << 8U | byte();
    value_ = std::min(value_, length_ - 1); // only damaged data exceeds it
  }

  template <unsigned N>
  unsigned
  symbol(SymbolModel<N>& model, unsigned /*value*/ = 0)
  {
    const std::uint32_t unit = length_ >> symbol_bits;
    const unsigned found = model.find(value_ / unit);
    const std::uint32_t low = model.low(found) * unit;
    const std::uint32_t high =
        found == model.last() ? length_ : model.low(found + 1) * unit;
    value_ -= low;
    length_ = high - low;
    normalize();
    model.count(found);
    return found;
  }

  unsigned
  bit(BitModel& model, unsigned /*value*/ = 0)
  {
    const std::uint32_t border = model.probability() * (length_ >> bit_bits);
    const unsigned found = value_ >= border ? 1 : 0;
    value_ -= found != 0 ? border : 0;
    length_ = found != 0 ? length_ - border : border;
    normalize();
    model.count(found);
    return found;
  }

  /** \brief \a count bits without a model, at most 32. */
  std::uint32_t
  bits(unsigned count, std::uint32_t /*value*/ = 0)
  {
    if (count > 19) {
      const std::uint32_t low = bits(16);
      return bits(count - 16) << 16U | low;
    }
    const std::uint32_t found = value_ / (length_ >>= count);
    value_ -= length_ * found;
    normalize();
    return found;
  }

  /** \brief 32 bits without a model. */
  std::uint32_t
  word(std::uint32_t /*value*/ = 0)
  {
    const std::uint32_t low = bits(16);
    return bits(16) << 16U | low;
  }

  /** \brief The first byte not read yet. */
  const std::uint8_t*
  next() const
  {
    return next_;
  }

  /** \brief Whether decoding ran past the end of the data. */
  bool
  overrun() const
  {
    return overrun_;
  }

private:
  std::uint32_t
  byte()
  {
    if (next_ < end_)
      return *next_++;
    overrun_ = true;
    return 0;
  }

  /** Shifts in whole bytes until the upper byte of the length is nonzero again. */
  void
  normalize()
  {
    const auto shift = static_cast<unsigned>(__builtin_clz(length_)) & 24U;
    length_ <<= shift;
    if (end_ - next_ >= 4) {
      const std::uint32_t more = std::uint32_t{next_[0]} << 24U |
                                 std::uint32_t{next_[1]} << 16U |
                                 std::uint32_t{next_[2]} << 8U | next_[3];
      value_ = static_cast<std::uint32_t>(
          ((std::uint64_t{value_} << 32U | more) << shift) >> 32U);
      next_ += shift / 8;
      return;
    }
    for (unsigned i = 0; i < shift; i += 8)
      value_ = value_ << 8U | byte();
  }

  const std::uint8_t* next_;
  const std::uint8_t* end_;
  std::uint32_t value_ = 0, length_ = 0xFFFFFFFFU;
  bool overrun_ = false;
};

} // namespace linelet::laz
