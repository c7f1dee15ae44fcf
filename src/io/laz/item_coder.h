// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

namespace linelet::laz {

/** \brief Codes one item of the points in turn, in a stream shared with the other items
 * (point formats 0 to 5). */
template <class Coder>
class ItemCoder {
public:
  virtual ~ItemCoder() = default;

  /** \brief Codes the bytes at \a at: reads them when encoding, writes them when
   * decoding. */
  virtual void
  code(Coder& coder, std::uint8_t* at) = 0;
};

} // namespace linelet::laz
