// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "models.h"

namespace linelet::laz {

/** \brief Codes red, green and blue byte by byte: which bytes differ from the previous
 * ones, and by how much; green and blue are predicted to change like red. */
class ColorModel {
public:
  using Color = std::array<std::uint16_t, 3>;

  template <class Coder>
  Color
  code(Coder& coder, const Color& before, const Color& value)
  {
    unsigned used = 0;
    if constexpr (Coder::encodes)
      used = differing(before, value);
    used = coder.symbol(used_, used);
    Color out = before;
    for (unsigned high = 0; high < 2; ++high)
      if ((used >> high & 1U) != 0)
        set(out[0], high, codeByte(coder, high, part(before[0], high), value[0]));
    if ((used & gray_differs) == 0)
      return {out[0], out[0], out[0]};
    for (unsigned high = 0; high < 2; ++high) {
      int step = part(out[0], high) - part(before[0], high);
      if ((used >> (2 + high) & 1U) != 0)
        set(out[1],
            high,
            codeByte(coder, 2 + high, part(before[1], high) + step, value[1]));
      step = (step + part(out[1], high) - part(before[1], high)) / 2;
      if ((used >> (4 + high) & 1U) != 0)
        set(out[2],
            high,
            codeByte(coder, 4 + high, part(before[2], high) + step, value[2]));
    }
    return out;
  }

private:
  static constexpr unsigned gray_differs = 64;

  static int
  part(std::uint16_t value, unsigned high)
  {
    return value >> (8 * high) & 0xFF;
  }

  static void
  set(std::uint16_t& value, unsigned high, unsigned byte)
  {
    value = static_cast<std::uint16_t>((value & (0xFFU << (8 * (1 - high)))) |
                                       byte << (8 * high));
  }

  static unsigned
  differing(const Color& before, const Color& value)
  {
    unsigned used = value[0] != value[1] || value[0] != value[2] ? gray_differs : 0;
    for (unsigned byte = 0; byte < 6; ++byte)
      if (part(before[byte / 2], byte % 2) != part(value[byte / 2], byte % 2))
        used |= 1U << byte;
    return used;
  }

  /** Codes byte \a which: the low and high bytes of red, green and blue in turn. */
  template <class Coder>
  unsigned
  codeByte(Coder& coder, unsigned which, int prediction, std::uint16_t value)
  {
    const auto expected = static_cast<unsigned>(std::clamp(prediction, 0, 255));
    const auto wanted = static_cast<unsigned>(part(value, which % 2));
    return (expected + coder.symbol(steps_[which], (wanted - expected) & 0xFFU)) &
           0xFFU;
  }

  SymbolModel<128> used_;
  std::array<SymbolModel<256>, 6> steps_;
};

} // namespace linelet::laz
