// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string_view>
#include <utility>

#include <bench/scenes/random.h>
#include <linelet/curves/curve_network.h>
#include <linelet/support/names.h>

namespace linelet::bench {

/** \brief Kinds of curves that are drawn at random. */
enum class ShapeFamily {
  Open,    ///< one smooth open curve
  Closed,  ///< one smooth closed curve
  Polygon, ///< closed, 3 to 7 straight sides
  Corners, ///< open, 2 to 5 straight sides
  Tree,    ///< a straight trunk, 2 to 4 straight branches that leave it or each other
  Parallel ///< 2 or 3 smooth open curves side by side
};

} // namespace linelet::bench

namespace linelet {

template <>
struct Names<bench::ShapeFamily> {
  using F = bench::ShapeFamily;
  static constexpr std::string_view kind = "shape family";
  static constexpr std::array<std::pair<F, std::string_view>, 6> table = {
      {{F::Open, "open"},
       {F::Closed, "closed"},
       {F::Polygon, "polygon"},
       {F::Corners, "corners"},
       {F::Tree, "tree"},
       {F::Parallel, "parallel"}}};
};

} // namespace linelet

namespace linelet::bench {

/** \brief Curves of \a family drawn at random, in a box around the origin whose longest
 * side is 10, in the plane z = 0 or in space.
 * \param[in] gap stretches of curve do not pass each other more closely than this, at
 * least 0; parallel curves lie at least this and at most 1 more apart */
CurveNetwork
randomShape(ShapeFamily family, bool flat, double gap, Random& random);

} // namespace linelet::bench
