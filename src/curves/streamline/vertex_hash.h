// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <linelet/support/points.h>

namespace linelet {

/** \brief Moving points by cell of an unbounded cubic grid. */
class VertexHash {
public:
  /** \param[in] cell edge of a cell, positive */
  explicit VertexHash(double cell) : cell_(cell) {}

  void
  insert(Index vertex, const Point& position)
  {
    cells_[key(cellOf(position))].push_back(vertex);
  }

  /** \brief Removes \a vertex, which was inserted at \a position. */
  void
  erase(Index vertex, const Point& position)
  {
    auto& content = cells_[key(cellOf(position))];
    content.erase(std::find(content.begin(), content.end(), vertex));
  }

  /** \brief Calls visit(vertex) once for every vertex in the cells that a ball touches,
   * and possibly for some others. */
  template <class Visit>
  void
  forEachNear(const Point& query, double radius, Visit&& visit) const
  {
    const double across = 2 * radius / cell_ + 1;
    if (across * across * across > 8 * static_cast<double>(cells_.size()) + 64) {
      for (const auto& entry : cells_)
        for (const Index vertex : entry.second)
          visit(vertex);
      return;
    }
    const Cell low = cellOf(query.array() - radius),
               high = cellOf(query.array() + radius);
    for (std::int64_t z = low[2]; z <= high[2]; ++z)
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
        for (std::int64_t x = low[0]; x <= high[0]; ++x) {
          const auto found = cells_.find(key({x, y, z}));
          if (found != cells_.end())
            for (const Index vertex : found->second)
              visit(vertex);
        }
  }

private:
  using Cell = Eigen::Matrix<std::int64_t, 3, 1>;

  Cell
  cellOf(const Point& p) const
  {
    return (p / cell_).array().floor().cast<std::int64_t>();
  }

  static std::uint64_t
  key(const Cell& c)
  {
    // 21 bits per axis: cells two million apart share a key.
    constexpr std::uint64_t mask = (1u << 21) - 1;
    return (static_cast<std::uint64_t>(c[0]) & mask) << 42 |
           (static_cast<std::uint64_t>(c[1]) & mask) << 21 |
           (static_cast<std::uint64_t>(c[2]) & mask);
  }

  double cell_;
  std::unordered_map<std::uint64_t, std::vector<Index>> cells_;
};

} // namespace linelet
