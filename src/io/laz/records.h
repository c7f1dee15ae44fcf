// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>

namespace linelet::laz {

/** \brief Point records of a chunk, one every \a stride bytes; 0: each overwrites the
 * previous one, if only the end of the chunk is needed. */
struct Records {
  std::uint8_t* first;
  std::size_t stride, count;

  std::uint8_t*
  at(std::size_t i) const
  {
    return first + i * stride;
  }
};

} // namespace linelet::laz
