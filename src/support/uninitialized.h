// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace linelet {

/** \brief An allocator that does not initialize numbers: for large arrays that all
 * threads should touch first. */
template <class T>
struct UninitializedAllocator : std::allocator<T> {
  template <class Other>
  struct rebind {
    using other = UninitializedAllocator<Other>;
  };

  template <class Other>
  void
  construct(Other* place)
  {
    ::new (static_cast<void*>(place)) Other;
  }

  template <class Other, class... Arguments>
  void
  construct(Other* place, Arguments&&... arguments)
  {
    ::new (static_cast<void*>(place)) Other(std::forward<Arguments>(arguments)...);
  }
};

/** \brief A vector whose resize leaves new numbers undefined. */
template <class T>
using UninitializedVector = std::vector<T, UninitializedAllocator<T>>;

} // namespace linelet
