// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace linelet {

/** \brief An array that grows cheaply, for values that are written before they are
 * read: new elements are uninitialized, and large arrays grow without being copied.
 *
 * Resizing a std::vector to an upper bound of many millions of values would touch all
 * of them, most for nothing. */
template <class T>
class WorkArray {
  static_assert(std::is_trivially_copyable_v<T>);

public:
  /** \brief Makes room for at least \a size values and keeps the existing ones. */
  void
  makeRoom(std::size_t size)
  {
    if (size <= size_)
      return;
    size = std::max(size, size_ + size_ / 2);
    void* grown = std::realloc(values_.get(), size * sizeof(T));
    if (grown == nullptr)
      throw std::bad_alloc();
    static_cast<void>(values_.release());
    values_.reset(static_cast<T*>(grown));
    size_ = size;
  }

  T*
  data()
  {
    return values_.get();
  }
  const T*
  data() const
  {
    return values_.get();
  }
  T&
  operator[](std::size_t i)
  {
    return values_.get()[i];
  }
  const T&
  operator[](std::size_t i) const
  {
    return values_.get()[i];
  }

private:
  struct Free {
    void
    operator()(T* values) const
    {
      std::free(values);
    }
  };

  std::unique_ptr<T, Free> values_;
  std::size_t size_ = 0;
};

} // namespace linelet
