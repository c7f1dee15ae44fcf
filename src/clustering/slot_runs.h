// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <linelet/support/points.h>

#include "cell_directory.h"

namespace linelet::clustering {

/** \brief The slots, divided into one run per thread, so that one thread visits all
 * points of a slot. */
class SlotRuns {
public:
  bool
  empty() const
  {
    return begins_.empty();
  }

  void
  clear()
  {
    begins_.clear();
  }

  /** \brief Cuts \a slots into runs of about as many points each.
   * \param[in] assigned slots of the points */
  void
  share(const Indices& assigned, std::size_t slots, int threads)
  {
    std::vector<std::uint32_t> counts(slots);
    std::size_t located = 0;
    for (const Index slot : assigned)
      if (slot != CellDirectory::none) {
        ++counts[slot];
        ++located;
      }
    begins_.assign(1, 0);
    std::size_t sum = 0;
    const auto parts = static_cast<std::size_t>(threads);
    for (std::size_t slot = 0; slot < slots; ++slot) {
      sum += counts[slot];
      if (sum * parts >= located * begins_.size() && begins_.size() < parts)
        begins_.push_back(static_cast<Index>(slot + 1));
    }
    begins_.push_back(static_cast<Index>(slots));
  }

  /** \brief Calls work(point, slot) for those of \a count points that \a slots gives
   * one. */
  template <class Work>
  void
  forPoints(const Index* slots, std::size_t count, int threads, const Work& work) const
  {
    const auto runs = static_cast<std::ptrdiff_t>(begins_.size()) - 1;
#pragma omp parallel for num_threads(threads) schedule(static, 1)
    for (std::ptrdiff_t run = 0; run < runs; ++run) {
      const Index first = begins_[static_cast<std::size_t>(run)];
      const Index width = begins_[static_cast<std::size_t>(run) + 1] - first;
      for (std::size_t i = 0; i < count; ++i)
        if (slots[i] - first < width)
          work(i, slots[i]);
    }
  }

private:
  Indices begins_;
};

} // namespace linelet::clustering
