// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include <linelet/support/names.h>
#include <linelet/support/visibility.h>
#include <linelet/tensor/centroid.h>
#include <linelet/tensor/neighborhood_tensor.h>
#include <linelet/tensor/weighting.h>

namespace LINELET_PUBLIC linelet {

/** \brief What finds the neighbors. All engines give the same neighbors. */
enum class Engine {
  Auto, ///< the cheapest one, see engine_choice.h
  Tree, ///< a kd-tree
  Grid  ///< a uniform grid
};

template <>
struct Names<Engine> {
  static constexpr std::string_view kind = "engine";
  static constexpr std::array<std::pair<Engine, std::string_view>, 3> table = {{
      {Engine::Auto, "auto"},
      {Engine::Tree, "tree"},
      {Engine::Grid, "grid"},
  }};
};

/** \brief What a neighborhood is and how its points are weighted. */
struct TensorSettings {
  double radius = 0;
  unsigned k = 0;
  Weighting weighting = Kernel::FermiDirac1;
  Centroid centroid = Centroid::QueryPoint;
  Weighting centroid_weighting = Kernel::QuadraticInverse;
  Normalization normalization = Normalization::Weights;
  Engine engine = Engine::Auto;
  unsigned threads = 0; ///< 0: all; the result is the same for any number
};

template <class Visit>
void
describe(TensorSettings& s, Visit&& visit)
{
  visit("radius", s.radius, "radius of every neighborhood, in the unit of the cloud");
  visit("knn", s.k, "number of nearest points per neighborhood, instead of a radius");
  visit("weight",
        s.weighting,
        "weighting kernel of the tensor: a name ('?' lists them), fermi-dirac:M,T or "
        "step:S");
  visit("centroid", s.centroid, "point of reference of the tensor");
  visit("centroid-weight",
        s.centroid_weighting,
        "weighting kernel of the weighted centroids");
  visit("normalization",
        s.normalization,
        "what the sum over the neighbors is divided by");
  visit("engine", s.engine, "what finds the neighbors");
}

/** \brief Sizes of neighborhoods per point, instead of TensorSettings::radius and
 * TensorSettings::k. One of the two may be given, with an entry for every query. */
struct NeighborhoodSizes {
  std::vector<double> radii;    ///< a point without a positive finite radius gets NaN
  std::vector<unsigned> counts; ///< numbers of nearest points; 0: the point gets NaN

  bool
  empty() const
  {
    return radii.empty() && counts.empty();
  }
};

/** \brief Whether a neighborhood can have this radius: positive and finite. */
inline bool
isRadius(double radius)
{
  return radius > 0 && std::isfinite(radius);
}

/** \brief Checks that exactly one valid neighborhood size is given.
 * \param[in] queries number of query points
 * \throws std::invalid_argument with the value and what is expected */
void
validate(const TensorSettings& settings,
         const NeighborhoodSizes& sizes,
         std::size_t queries);

} // namespace linelet
