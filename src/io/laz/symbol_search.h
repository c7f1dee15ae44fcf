// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace linelet::laz {

/** \brief Bit i is set if values[i] > limit, for 16 values. */
inline std::uint32_t
greaterThan(const std::int16_t* values, std::int16_t limit)
{
#if defined(__SSE2__)
  const __m128i limits = _mm_set1_epi16(limit);
  const __m128i low =
      _mm_cmpgt_epi16(_mm_load_si128(reinterpret_cast<const __m128i*>(values)), limits);
  const __m128i high = _mm_cmpgt_epi16(
      _mm_load_si128(reinterpret_cast<const __m128i*>(values + 8)), limits);
  return static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_packs_epi16(low, high)));
#else
  std::uint32_t mask = 0;
  for (unsigned i = 0; i < 16; ++i)
    mask |= static_cast<std::uint32_t>(values[i] > limit) << i;
  return mask;
#endif
}

/** \brief Index of the last of \a Count ascending values that is at most \a limit; the
 * first one always is. \a values has room for full groups of 16, and Count <= 64. */
template <unsigned Count>
unsigned
lastAtMost(const std::int16_t* values, std::int16_t limit)
{
  static_assert(Count <= 64);
  std::uint64_t greater = 0;
  for (unsigned group = 0; group < (Count + 15) / 16; ++group)
    greater |= std::uint64_t{greaterThan(values + 16 * group, limit)} << (16 * group);
  // Branch-free, since symbols are too random for branch prediction.
  return static_cast<unsigned>(
      __builtin_ctzll((greater >> 1U) | (std::uint64_t{1} << (Count - 1U))));
}

} // namespace linelet::laz
