// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

namespace linelet::clustering {

/** \brief The positions of the bits set in a byte, one byte each. */
struct SetBits {
  std::uint8_t places[256][8] = {};

  constexpr SetBits()
  {
    for (unsigned bits = 0; bits < 256; ++bits) {
      unsigned count = 0;
      for (std::uint8_t place = 0; place < 8; ++place)
        if (((bits >> place) & 1U) != 0)
          places[bits][count++] = place;
    }
  }
};

inline constexpr SetBits set_bits;

} // namespace linelet::clustering
