// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "curve_track.h"

namespace linelet {

/** \brief Hands out seeds in groups that are followed side by side: the best of all
 * that are left, and the next ones of its cell in a cubic lattice.
 *
 * Which seeds come together, and in which order nearby seeds come, depends only on the
 * seeds around them: it is the same in a part of a cloud as in the whole.
 */
class SeedGroups {
public:
  /** \param[in] seeds the best first; outlives this
   * \param[in] side of the cells */
  SeedGroups(const std::vector<TrackSeed>& seeds, double side);

  /** \brief The next group; empty if none is left.
   * \param[in] most seeds of it
   * \param[in] is_open whether a seed is still worth following; others are left out */
  std::vector<TrackSeed>
  next(std::size_t most, const std::function<bool(const TrackSeed&)>& is_open);

  /** \brief Number of seeds handed out or left out. */
  std::size_t
  passed() const
  {
    return passed_;
  }

private:
  const std::vector<TrackSeed>& seeds_;
  std::vector<std::size_t> cell_of_;            // by seed
  std::vector<std::vector<std::size_t>> cells_; // seeds that are left, the best last
  std::size_t best_ = 0;                        // of all, unless it has passed
  std::size_t passed_ = 0;
};

} // namespace linelet
