// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string_view>
#include <utility>

#include <linelet/support/names.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief How a normal is computed. */
enum class ScreenNormalMethod {
  LocalDerivatives, ///< LD: the steps to the next pixels, n = d/dy x d/dx
  PlaneDiagonals,   ///< PD: cross products of diagonals between opposite samples
  PlaneCircle,      ///< PC: mean of the normals of the triangles around the center
  Tensor            ///< TI: smallest eigenvector of sum d (x) d / |d|
};

template <>
struct Names<ScreenNormalMethod> {
  static constexpr std::string_view kind = "normal method";
  static constexpr std::array<std::pair<ScreenNormalMethod, std::string_view>, 4>
      table = {{{ScreenNormalMethod::LocalDerivatives, "derivatives"},
                {ScreenNormalMethod::PlaneDiagonals, "diagonals"},
                {ScreenNormalMethod::PlaneCircle, "circle"},
                {ScreenNormalMethod::Tensor, "tensor"}}};
};

/** \brief How screen-space normals are estimated (Schiffner et al. 2013).
 *
 * Under noise, derivatives are by far the worst, and triangles worse than the other
 * two. The diagonals are the least-squares slope of their samples, the best there is on
 * a plane; the tensor comes close to them, and next to edges, gaps and the distance
 * limit it uses every sample, while triangles need pairs and diagonals need four.
 *
 * The weight of the tensor is 1/|d|: the publication prints the norm with a 2 beside
 * it, which may mean the 2-norm or its square; with the square, errors are larger. */
struct ScreenNormalSettings {
  ScreenNormalMethod method = ScreenNormalMethod::Tensor;
  /// Pixels used: 5, 9, 17 or 25. The publication shows their positions only in a
  /// figure; ours are rings of four, in this order: the diagonals at 1 and 2 pixels,
  /// (2, 0) and its rotations, the diagonals at 3, (1, 0), (3, 0). 5 takes one ring, 9
  /// two, 17 four, 25 six.
  unsigned samples = 9;
  double max_distance = 0; ///< samples farther from the pixel's own are ignored, in the
                           ///< unit of the cloud; 0: none are
  unsigned smoothing = 0;  ///< passes of a weighted mean over 3 x 3 normals
  unsigned threads = 0;    ///< 0: all; the result is the same for any number
};

template <class Visit>
void
describe(ScreenNormalSettings& s, Visit&& visit)
{
  visit("normal-method", s.method, "normals: how they are computed");
  visit(
      "normal-samples", s.samples, "normals: number of pixels sampled, 5, 9, 17 or 25");
  visit("normal-distance",
        s.max_distance,
        "normals: ignore samples farther than this, in the unit of the cloud; 0: use "
        "all");
  visit("normal-smoothing", s.smoothing, "normals: number of smoothing passes");
}

/** \brief Checks the settings. \throws std::invalid_argument */
void
validate(const ScreenNormalSettings& settings);

} // namespace linelet
