// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <linelet/io/cloud.h>
#include <linelet/io/usable_points.h>

#include "scene.h"

namespace linelet::view {

/** \brief The points that an analysis works on, and where its results go. */
struct Part {
  Indices indices; ///< in the cloud; empty: all of it
  bool all = true;

  /** \throws std::invalid_argument if no point lies in \a box */
  Part(const Scene& scene, const std::optional<Box>& box);

  /** \brief The values of \a whole at these points. */
  template <class T>
  std::vector<T>
  of(const std::vector<T>& whole) const
  {
    if (all)
      return whole;
    std::vector<T> part;
    part.reserve(indices.size());
    for (const Index i : indices)
      part.push_back(whole[i]);
    return part;
  }

  /** \brief The values of \a part at their points, \a elsewhere at all others. */
  template <class T>
  std::vector<T>
  spread(std::vector<T> part, std::size_t count, const T& elsewhere) const
  {
    if (all)
      return part;
    std::vector<T> whole(count, elsewhere);
    for (std::size_t k = 0; k < indices.size() && k < part.size(); ++k)
      whole[indices[k]] = std::move(part[k]);
    return whole;
  }
};

/** \brief The points, with the attributes that decide whether they are used. */
io::Cloud
cloudOf(const Scene& scene, const Part& part);

/** \brief The points of \a part that are usable according to \a classes; NaN for the
 * others. */
Points
usablePoints(const Scene& scene, const Part& part, const io::ClassFilter& classes);

} // namespace linelet::view
