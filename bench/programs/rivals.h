// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>

#include <linelet/support/points.h>

namespace linelet::benchmarking {

/** \brief CPU seconds of another library: to build its tree, and per query. */
struct RivalTime {
  double build, query;
};

/** \brief pcl::NormalEstimationOMP with its FLANN kd-tree at \a sample of the
 * points. */
RivalTime
pclNormals(const Points& points, double radius, unsigned threads, std::size_t sample);

/** \brief pcl::KdTreeFLANN, radius search, unsorted results. */
RivalTime
flannSearch(const Points& points, double radius, std::size_t sample);

/** \brief nanoflann in double, radius search, unsorted results. */
RivalTime
nanoflannSearch(const Points& points, double radius, std::size_t sample);

/** \brief nanoflann in double, the \a count nearest. */
RivalTime
nanoflannNearest(const Points& points, std::size_t count, std::size_t sample);

} // namespace linelet::benchmarking
