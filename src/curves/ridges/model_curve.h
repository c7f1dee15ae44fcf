// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <linelet/support/points.h>

namespace linelet {

/** \brief A curve while it is being fitted: a polyline of nearly equal edges. */
struct ModelCurve {
  Points nodes;        ///< vertices; a closed curve does not repeat its first one
  bool closed = false; ///< whether the last node is joined to the first
  std::array<int, 2> junction = {-1, -1}; ///< of the front and the back end; -1: free
  /// Nodes at which it may turn sharply, ascending; never ends.
  std::vector<std::size_t> hinges;
  double scale = 0;           ///< bandwidth of the ridges it comes from
  std::vector<double> counts; ///< points explained by each edge, or empty
  double noise = 0;    ///< standard deviation of its points about it, per coordinate
  double evidence = 0; ///< log-likelihood ratio of curve to background

  /** \brief Number of edges. */
  std::size_t
  edges() const
  {
    return nodes.size() < 2 ? 0 : nodes.size() - (closed ? 0 : 1);
  }

  /** \brief Start and end of edge \a e. */
  const Point&
  from(std::size_t e) const
  {
    return nodes[e];
  }
  const Point&
  to(std::size_t e) const
  {
    return nodes[e + 1 == nodes.size() ? 0 : e + 1];
  }
};

using ModelCurves = std::vector<ModelCurve>;

/** \brief Length of \a curve, its closing edge included. */
double
length(const ModelCurve& curve);

/** \brief Total length of \a curves. */
double
length(const ModelCurves& curves);

/** \brief Square of the distance of \a p from edge \a e of \a curve. */
double
squaredDistance(const ModelCurve& curve, std::size_t e, const Point& p);

/** \brief \a curve with nodes at equal arc lengths about \a spacing apart, at least 2
 * (closed: 4); ends and hinges keep their positions. */
ModelCurve
resampled(const ModelCurve& curve, double spacing);

class ScaleField;

/** \brief \a curve with nodes about \a spacing times the local scale apart, on at least
 * \a least_edges edges. */
ModelCurve
resampled(const ModelCurve& curve,
          double spacing,
          const ScaleField& scales,
          double least_edges);

/** \brief Unit vector that points out of \a curve at its front (end 0) or back (end 1),
 * taken over the last \a reach of its length. */
Point
outwardDirection(const ModelCurve& curve, int end, double reach);

} // namespace linelet
