// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include <linelet/support/names.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Why a curve ends where it ends. */
enum class EndKind {
  Cutoff,     ///< open: no cloud point within the distance cutoff
  Bounds,     ///< open: left the bounding box of the cloud
  Iterations, ///< open: the largest number of steps was reached
  Support,    ///< open: the points ahead do not support the curve
  Junction,   ///< joined to other curves, see CurveEnd::junction
  Loop        ///< joined to its own other end: the curve is closed
};

template <>
struct Names<EndKind> {
  static constexpr std::string_view kind = "end kind";
  static constexpr std::array<std::pair<EndKind, std::string_view>, 6> table = {
      {{EndKind::Cutoff, "cutoff"},
       {EndKind::Bounds, "bounds"},
       {EndKind::Iterations, "iterations"},
       {EndKind::Support, "support"},
       {EndKind::Junction, "junction"},
       {EndKind::Loop, "loop"}}};
};

/** \brief One end of a curve. */
struct CurveEnd {
  EndKind kind = EndKind::Cutoff;
  int junction = -1; ///< index in CurveNetwork::junctions if kind is Junction, else -1
};

/** \brief A polyline: an ordered run of vertices. */
struct Curve {
  Points points;       ///< vertices; a closed curve does not repeat its first one
  bool closed = false; ///< whether the last vertex is joined to the first
  CurveEnd front;      ///< the end at points.front()
  CurveEnd back;       ///< the end at points.back()
  /// Number of cloud points that each vertex explains; may be empty
  std::vector<Index> support;
  /// Standard deviation of its points about it, per coordinate, due to noise or to a
  /// bundle too narrow to be resolved. NaN if unknown.
  double noise = std::numeric_limits<double>::quiet_NaN();
  /// Points per length; NaN if unknown
  double density = std::numeric_limits<double>::quiet_NaN();
  /// Natural log-likelihood ratio of the curve to background alone; NaN if unknown
  double evidence = std::numeric_limits<double>::quiet_NaN();
};

/** \brief A place where curves meet. */
struct Junction {
  Point position = Point::Zero();
  std::vector<std::size_t> curves; ///< indices in CurveNetwork::curves, ascending
};

/** \brief The result of a reconstruction: polylines and how they are connected. */
struct CurveNetwork {
  std::vector<Curve> curves;
  std::vector<Junction> junctions;
};

/** \brief Length of \a curve, its closing edge included. */
double
length(const Curve& curve);

/** \brief Length of all curves of \a network. */
double
length(const CurveNetwork& network);

} // namespace linelet
