// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include <linelet/features/point_types.h>
#include <linelet/search/neighbor_search.h>
#include <linelet/support/names.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/tensor/centroid.h>
#include <linelet/tensor/neighborhood_tensor.h>
#include <linelet/tensor/weighting.h>

namespace linelet {

/** \brief What finds the neighbors. All engines give the same neighbors. */
enum class Engine {
  Auto,  ///< the cheapest one, see engine_choice.h
  Tree,  ///< a kd-tree
  Grid,  ///< a uniform grid
  OpenCL ///< an OpenCL device; runs through opencl::TensorEngine alone
};

template <>
struct Names<Engine> {
  static constexpr std::string_view kind = "engine";
  static constexpr std::array<std::pair<Engine, std::string_view>, 4> table = {{
      {Engine::Auto, "auto"},
      {Engine::Tree, "tree"},
      {Engine::Grid, "grid"},
      {Engine::OpenCL, "opencl"},
  }};
};

/** \brief What a neighborhood is and how its points count. */
struct TensorSettings {
  double radius = 0;
  unsigned k = 0;
  Weighting weighting = Kernel::FermiDirac1;
  Centroid centroid = Centroid::QueryPoint;
  Weighting centroid_weighting = Kernel::QuadraticInverse;
  Engine engine = Engine::Auto;
  unsigned threads = 0; ///< 0: all; the result is the same for any number
};

template <class Visit>
void
describe(TensorSettings& s, Visit&& visit)
{
  visit("radius", s.radius, "radius of every neighborhood, in the unit of the cloud");
  visit("knn", s.k, "number of nearest points that make a neighborhood, instead");
  visit("weight",
        s.weighting,
        "weighting of the tensor: the name of a kernel ('?' lists them), "
        "fermi-dirac:M,T or step:S");
  visit("centroid", s.centroid, "point of reference");
  visit("centroid-weight", s.centroid_weighting, "weighting of weighted centroids");
  visit("engine", s.engine, "what finds the neighbors");
}

/** \brief Sizes of neighborhoods point by point, instead of TensorSettings::radius and
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

/** \brief Checks that exactly one size of neighborhood is said, and that it makes
 * sense.
 * \param[in] queries number of query points
 * \throws std::invalid_argument with the value and what is expected */
void
validate(const TensorSettings& settings,
         const NeighborhoodSizes& sizes,
         std::size_t queries);

/** \brief The record of one neighborhood: centroid, tensor, eigen-analysis and shape
 * factors, all in double. Every engine is this, or is tested against it.
 * \param[in] offsets neighbors relative to the query point
 * \param[in] radius of the neighborhood, 0 where all neighbors lie at the query point
 */
PointDistributionTensor
tensorOf(const Points& offsets, double radius, const TensorSettings& settings);

/** \brief The record of a tensor: eigen-analysis and shape factors.
 * \param[in] tensor of the neighborhood
 * \param[in] extent distance of the farthest neighbor, see \ref shapeFactors
 * \param[in] neighbors number of neighbors */
PointDistributionTensor
recordOf(const SymmetricTensor& tensor, double extent, std::uint32_t neighbors);

/** \brief The record of a point of which nothing is known, with the number of
 * neighbors that were found. */
PointDistributionTensor
unknownTensor(std::uint32_t neighbors);

/** \brief The neighborhood tensor of every query point (Ritter et al. 2012).
 * \param[in] surface the points that neighborhoods are made of
 * \param[in] queries points around which they are made; a query that is not finite gets
 * NaN
 * \param[in] settings with a radius or k, or neither if \a sizes says them point by
 * point
 * \return one record a query, in order
 * \throws std::invalid_argument see \ref validate
 * \throws Canceled */
std::vector<PointDistributionTensor>
estimateTensors(const Points& surface,
                const Points& queries,
                const TensorSettings& settings,
                const NeighborhoodSizes& sizes = {},
                ProgressMonitor* monitor = nullptr);

/** \brief The same with neighbors from \a search over \a surface; the engine of
 * \a settings has no say. */
std::vector<PointDistributionTensor>
estimateTensors(const NeighborSearch& search,
                const Points& surface,
                const Points& queries,
                const TensorSettings& settings,
                const NeighborhoodSizes& sizes = {},
                ProgressMonitor* monitor = nullptr);

} // namespace linelet
