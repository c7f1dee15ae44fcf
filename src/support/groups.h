// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace linelet {

/** \brief Union-find: disjoint groups of 0, 1, ..., each alone at first. */
class Groups {
public:
  explicit Groups(std::size_t count) : parent_(count)
  {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  /** \brief The representative of the group of \a i. */
  std::size_t
  root(std::size_t i)
  {
    while (parent_[i] != i)
      i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  /** \brief Unites the groups of \a i and \a j.
   * \return whether they were distinct */
  bool
  unite(std::size_t i, std::size_t j)
  {
    const std::size_t a = root(i), b = root(j);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

private:
  std::vector<std::size_t> parent_;
};

} // namespace linelet
