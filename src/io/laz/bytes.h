// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace linelet::laz {

/** \brief Pointer to the first of \a bytes. */
inline const std::uint8_t*
beginOf(std::string_view bytes)
{
  return reinterpret_cast<const std::uint8_t*>(bytes.data());
}

/** \brief Little-endian number at \a at. */
template <class T>
T
load(const std::uint8_t* at)
{
  std::uint64_t value = 0;
  for (unsigned i = 0; i < sizeof(T); ++i)
    value |= std::uint64_t{at[i]} << (8 * i);
  return static_cast<T>(value);
}

template <class T>
void
store(std::uint8_t* at, T value)
{
  for (unsigned i = 0; i < sizeof(T); ++i)
    at[i] = static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8 * i));
}

} // namespace linelet::laz
