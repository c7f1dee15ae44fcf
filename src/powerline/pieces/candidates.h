// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/powerline/ground.h>
#include <linelet/search/uniform_grid.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>

namespace linelet::powerline {

/** \brief The points above ground, which all later stages search. */
struct Candidates {
  Points points;
  Indices input;             ///< index of each in the input
  std::vector<float> height; ///< above ground, meters
  UniformGrid grid;
  double least_height; ///< above ground, of all of them, meters
};

/** \brief Points higher above \a ground than \a min_height, in input order.
 * \param[in] threads 0: all */
Candidates
findCandidates(const Points& points,
               const Ground& ground,
               double min_height,
               unsigned threads = 0);

/** \brief A place where there may be a wire, with its direction. */
struct Seed {
  Index candidate;
  float linearity;
  float radius;    ///< of the neighborhood that showed it, meters
  Point direction; ///< unit length
};

/** \brief Candidates whose neighborhood at one of several radii (1, 2, 4, 8 m) is a
 * nearly horizontal line, best first. One per voxel of half a meter is tried. */
std::vector<Seed>
findSeeds(const Candidates& candidates, unsigned threads, ProgressMonitor* monitor);

} // namespace linelet::powerline
