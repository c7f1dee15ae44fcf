// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace linelet {

/** \brief Reserves \a count elements in an empty vector, in huge pages if the system
 * has them: random access to large arrays spends much of its time looking up pages. */
template <class T, class Allocator>
void
reserveHuge(std::vector<T, Allocator>& elements, std::size_t count)
{
  elements.reserve(count);
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::uintptr_t page = std::uintptr_t{1} << 21;
  const auto begin = reinterpret_cast<std::uintptr_t>(elements.data());
  const std::uintptr_t first = (begin + page - 1) / page * page;
  const std::uintptr_t last = (begin + count * sizeof(T)) / page * page;
  // A hint: nothing depends on it.
  if (first < last)
    madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#endif
}

} // namespace linelet
