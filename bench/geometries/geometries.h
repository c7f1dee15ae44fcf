// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include <linelet/curves/curve_network.h>
#include <linelet/support/names.h>

namespace linelet::bench {

/** \brief A known curve of extent about 10 to reconstruct from noisy samples.
 *
 * The first ten are the geometries of Ritter, Schiffner, Harders 2021, which the
 * benchmark grid runs over. The others are held out of that grid. Changes have been
 * judged on them, too, so that they are no longer unseen. */
enum class Geometry {
  Circle,      ///< radius 5, closed
  Rectangle,   ///< 10 x 8, closed
  Triangle,    ///< equilateral, side 10, closed
  Line,        ///< one segment
  Wave,        ///< two periods of a sine of amplitude 2
  Crossing,    ///< two diagonals of a square
  Elbow,       ///< three segments, two right angles, in space
  Helix,       ///< two turns of radius 3, height 10
  Mikado,      ///< four segments that pass close to each other
  Crossing3d,  ///< three segments along the axes through the origin
  FigureEight, ///< held out: closed, passes over itself at a distance of 3
  YBranch,     ///< held out: three arms from one point
  Tee,         ///< held out: an arm from the middle of a segment
  Parallel,    ///< held out: two segments of length 10 at a distance of 1
  Vee,         ///< held out: a corner of 30 degrees
  Spiral,      ///< held out: 2.25 turns, 1.78 apart
  SCurve,      ///< held out: two half circles, sampling density falls fourfold along it
  Star,        ///< held out: outline of a five-pointed star, closed
  Trefoil      ///< held out: the trefoil knot, closed
};

} // namespace linelet::bench

namespace linelet {

template <>
struct Names<bench::Geometry> {
  using G = bench::Geometry;
  static constexpr std::string_view kind = "geometry";
  static constexpr std::array<std::pair<G, std::string_view>, 19> table = {
      {{G::Circle, "circle"},
       {G::Rectangle, "rectangle"},
       {G::Triangle, "triangle"},
       {G::Line, "line"},
       {G::Wave, "wave"},
       {G::Crossing, "crossing"},
       {G::Elbow, "elbow"},
       {G::Helix, "helix"},
       {G::Mikado, "mikado"},
       {G::Crossing3d, "crossing3d"},
       {G::FigureEight, "figure-eight"},
       {G::YBranch, "y-branch"},
       {G::Tee, "tee"},
       {G::Parallel, "parallel"},
       {G::Vee, "vee"},
       {G::Spiral, "spiral"},
       {G::SCurve, "s-curve"},
       {G::Star, "star"},
       {G::Trefoil, "trefoil"}}};
};

} // namespace linelet

namespace linelet::bench {

/** \brief The ten geometries of the benchmark grid. */
const std::vector<Geometry>&
benchmarkGeometries();

/** \brief The held-out shapes. */
const std::vector<Geometry>&
heldOutGeometries();

/** \brief The curves of \a geometry, one per component, as polylines whose vertices lie
 * on the curve (smooth ones every 0.06 or closer, so that a chord is off by less than
 * 5e-4).
 * \param[in] out_of_plane adds out_of_plane * cos(pi/2 (y - C_y) / (2 d_y)) to z, with
 * C_y and d_y the center and the extent of the geometry in y (0: nothing) */
CurveNetwork
truthOf(Geometry geometry, double out_of_plane = 0);

/** \brief \a network bent in the same way. */
CurveNetwork
bentOutOfPlane(CurveNetwork network, double out_of_plane);

/** \brief Sampling density at arc position t in [0, 1] of \a geometry relative to its
 * start: 1 except where it varies. */
double
densityOf(Geometry geometry, double t);

} // namespace linelet::bench
