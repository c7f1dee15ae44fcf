// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "models.h"

namespace linelet::laz {

/** \brief Codes integers of \a Bits bits as differences from a prediction.
 *
 * The number k of bits of the difference is a symbol of a model with \a Contexts
 * contexts (0: as many as passed to the constructor); its rank among the differences of
 * k bits is a symbol for the upper 8 bits, and raw below. */
template <unsigned Bits, unsigned Contexts = 1>
class IntegerModel {
public:
  explicit IntegerModel(std::size_t contexts = Contexts)
  {
    if constexpr (Contexts == 0)
      sizes_.resize(contexts);
    for (unsigned k = 1; k < places_.size(); ++k)
      places_[k] = SymbolModel<256>(1U << std::min(k, 8U));
  }

  /** \brief Codes \a value; returns it modulo 2^Bits. */
  template <class Coder>
  std::uint32_t
  code(Coder& coder,
       std::uint32_t prediction,
       std::uint32_t value = 0,
       unsigned context = 0)
  {
    std::int32_t difference = 0;
    if constexpr (Coder::encodes)
      difference = extended(value - prediction);
    return (prediction + static_cast<std::uint32_t>(
                             codeDifference(coder, difference, sizes_[context]))) &
           mask;
  }

  /** \brief Number of bits of the last difference. */
  unsigned
  size() const
  {
    return size_;
  }

private:
  static constexpr std::uint32_t mask = Bits == 32 ? ~0U : (1U << (Bits % 32)) - 1U;

  /** The number of smallest magnitude that equals \a value modulo 2^Bits. */
  static std::int32_t
  extended(std::uint32_t value)
  {
    return static_cast<std::int32_t>(value << (32 - Bits)) >> (32 - Bits);
  }

  /** 0 and 1 have size 0; k bits: -(2^k - 1) to -2^(k-1), and 2^(k-1) + 1 to 2^k. */
  static unsigned
  sizeOf(std::int32_t difference)
  {
    const std::uint32_t distance = difference <= 0
                                       ? 0U - static_cast<std::uint32_t>(difference)
                                       : static_cast<std::uint32_t>(difference) - 1U;
    return distance == 0 ? 0 : 32U - static_cast<unsigned>(__builtin_clz(distance));
  }

  template <class Coder>
  std::int32_t
  codeDifference(Coder& coder, std::int32_t difference, SymbolModel<Bits + 1>& sizes)
  {
    const unsigned k = size_ = coder.symbol(sizes, sizeOf(difference));
    if (k == 0)
      return static_cast<std::int32_t>(
          coder.bit(bit_, static_cast<unsigned>(difference)));
    if (k == 32)
      return INT32_MIN;
    // Ranks count from the lower end of both ranges.
    std::uint32_t place = static_cast<std::uint32_t>(difference) +
                          (difference < 0 ? (1U << k) - 1U : ~0U);
    if (k <= 8)
      place = coder.symbol(places_[k], place);
    else {
      const unsigned raw = k - 8;
      const std::uint32_t high = coder.symbol(places_[k], place >> raw);
      place = high << raw | coder.bits(raw, place & ((1U << raw) - 1U));
    }
    const bool upper = place >= (1U << (k - 1));
    return static_cast<std::int32_t>(upper ? place + 1U : place - ((1U << k) - 1U));
  }

  using Sizes = SymbolModel<Bits + 1>;
  std::conditional_t<Contexts == 0, std::vector<Sizes>, std::array<Sizes, Contexts>>
      sizes_;
  BitModel bit_;
  std::array<SymbolModel<256>, Bits == 32 ? 32 : Bits + 1> places_;
  unsigned size_ = 0;
};

} // namespace linelet::laz
