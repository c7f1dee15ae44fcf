// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "cell_directory.h"

namespace linelet::clustering {

/** \brief Bits that several threads set. */
class SharedBits {
public:
  explicit SharedBits(std::size_t words) : words_(words) {}

  /** \brief Sets a bit; most are set already, which is cheaper to test than to set. */
  void
  set(std::uint64_t number)
  {
    std::atomic<std::uint32_t>& word = words_[number / 32];
    const std::uint32_t bit = 1U << (number % 32);
    if ((word.load(std::memory_order_relaxed) & bit) == 0)
      word.fetch_or(bit, std::memory_order_relaxed);
  }

  void
  copyTo(RankedBits& set) const
  {
    set.words.resize(words_.size());
    for (std::size_t i = 0; i < words_.size(); ++i)
      set.words[i] = words_[i].load(std::memory_order_relaxed);
    set.rank();
  }

private:
  std::vector<std::atomic<std::uint32_t>> words_;
};

} // namespace linelet::clustering
