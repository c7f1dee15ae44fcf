// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include <linelet/features/linearity_graph.h>
#include <linelet/features/multi_scale_radii.h>
#include <linelet/support/names.h>
#include <linelet/support/visibility.h>
#include <linelet/tensor/centroid.h>
#include <linelet/tensor/weighting.h>

namespace LINELET_PUBLIC linelet {

/** \brief How neighborhoods are measured. */
enum class ScaleEngine {
  Auto,  ///< Sweep for small clouds and for few queries among many points, else Grid
  Sweep, ///< one search at the largest radius serves all scales, all in double
  Grid   ///< one vectorized sweep over all scales, shape factors to 1e-4
};

template <>
struct Names<ScaleEngine> {
  static constexpr std::string_view kind = "engine";
  static constexpr std::array<std::pair<ScaleEngine, std::string_view>, 3> table = {
      {{ScaleEngine::Auto, "auto"},
       {ScaleEngine::Sweep, "sweep"},
       {ScaleEngine::Grid, "grid"}}};
};

/** \brief Parameters of the multi-scale shape feature. */
struct MultiScaleSettings {
  Weighting weighting; ///< w_T of the tensor
  Centroid centroid = Centroid::QueryPoint;
  Weighting centroid_weighting = Kernel::QuadraticInverse; ///< w_C
  RadiusGrowth growth = RadiusGrowth::Exponential;
  double max_radius = 0; ///< unit of the points; 0: 60 D
  /// Ascending; if not empty, used instead of growth and max_radius
  std::vector<double> radii;
  /// Stop rule: the largest radius is the first at which the shape factors of no point
  /// differ by this much from those at the radius before. Only for the mean and median
  /// centroids, where they converge. 0: off.
  double stop_change = 0;
  double scale_unit = 0;             ///< D; 0: measured on the points
  unsigned scale_unit_sample = 1024; ///< points that D is measured at; 0: all
  unsigned scale_unit_seed = 1;
  ScaleEngine engine = ScaleEngine::Auto;
  LinearityGraphSettings graph; ///< how the optimal scale is chosen
  unsigned threads = 0;         ///< 0: all
};

template <class Visit>
void
describe(MultiScaleSettings& s, Visit&& visit)
{
  visit("weight",
        s.weighting,
        "weighting kernel of the tensor: a name ('?' lists them), fermi-dirac:M,T or "
        "step:S");
  visit("centroid", s.centroid, "point of reference of the tensor");
  visit("centroid-weight",
        s.centroid_weighting,
        "weighting kernel of the weighted centroids");
  visit("growth", s.growth, "how the radii grow from the scale unit D");
  visit(
      "max-radius", s.max_radius, "largest radius, in the unit of the cloud; 0: 60 D");
  visit("radii", s.radii, "radii, ascending, instead of growth and largest radius");
  visit("stop-change",
        s.stop_change,
        "stop at the first radius where the shape factors of all points change by less "
        "than this (mean and median centroids); 0: off");
  visit("scale-unit",
        s.scale_unit,
        "scale unit D, in the unit of the cloud; 0: measured");
  visit("scale-unit-sample",
        s.scale_unit_sample,
        "number of points at which D is measured; 0: all");
  visit("scale-unit-seed", s.scale_unit_seed, "seed of that sample");
  visit("engine",
        s.engine,
        "how neighborhoods are measured; auto: sweep for small clouds, else grid");
  describe(s.graph, visit);
}

} // namespace linelet
