// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include <linelet/features/cloud_piece.h>
#include <linelet/features/linearity_graph.h>
#include <linelet/features/multi_scale_radii.h>
#include <linelet/features/multi_scale_types.h>
#include <linelet/search/neighbor_search.h>
#include <linelet/support/names.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>
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
        "stop at the first radius where no shape factor of any point changes by this "
        "much any more (mean and median centroids); 0: off");
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

/** \brief The multi-scale shape feature of a set of points. */
struct MultiScaleShapes {
  double scale_unit = 0;     ///< D; NaN where the points have none (see scaleUnit)
  std::vector<double> radii; ///< of the scales, ascending
  std::vector<MultiScaleShape> shapes; ///< one per query
};

/** \brief Receives the graphs of every query, in the order of the queries and never
 * from two threads at once. The graph is valid during the call. */
using ShapeGraphSink = std::function<void(std::size_t query, const ShapeGraph& graph)>;

/** \brief Radii that \a settings ask for on \a surface, the stop rule applied.
 * \return with scale_unit and radii set, without shapes
 * \throws std::invalid_argument if a parameter is out of range, or if D is needed and
 * the points have none */
MultiScaleShapes
multiScaleRadii(const Points& surface,
                const MultiScaleSettings& settings,
                ProgressMonitor* monitor = nullptr);

/** \brief The same, with neighbors from \a search over \a surface. */
MultiScaleShapes
multiScaleRadii(const NeighborSearch& search,
                const Points& surface,
                const MultiScaleSettings& settings,
                ProgressMonitor* monitor = nullptr);

/** \brief The engine that \ref multiScaleShapes runs: what ScaleEngine::Auto stands
 * for, judged by the numbers of points and queries and the neighbors that a sample of
 * the queries has within the largest radius. */
ScaleEngine
chosenScaleEngine(const Points& surface,
                  const Points& queries,
                  double largest_radius,
                  const MultiScaleSettings& settings);

/** \brief The multi-scale shape feature (Ritter, Schiffner, Harders 2021): the shape of
 * the neighborhood of every query at a sequence of radii, and the scale that serves the
 * reconstruction of curves best.
 *
 * One search at the largest radius serves all scales. The tensor at radius r is that of
 * the points with d <= r; scales with fewer than two neighbors away from the query are
 * not defined. Nothing is kept per scale: \a sink receives the graphs as they are
 * computed. The result does not depend on the number of threads.
 *
 * \param[in] surface points among which neighbors are sought; those with a coordinate
 * that is not finite are left out
 * \param[in] queries where the feature is computed; NaN for one that is not finite. A
 * query that should count as its own neighbor must be in \a surface as well
 * \throws std::invalid_argument as \ref multiScaleRadii; Canceled */
MultiScaleShapes
multiScaleShapes(const Points& surface,
                 const Points& queries,
                 const MultiScaleSettings& settings = {},
                 const ShapeGraphSink& sink = {},
                 ProgressMonitor* monitor = nullptr);

/** \brief The same, with neighbors from \a search over \a surface; the engine of \a
 * settings has no effect. */
MultiScaleShapes
multiScaleShapes(const NeighborSearch& search,
                 const Points& surface,
                 const Points& queries,
                 const MultiScaleSettings& settings = {},
                 const ShapeGraphSink& sink = {},
                 ProgressMonitor* monitor = nullptr);

/** \brief The same for the points of a piece of a cloud: \a points also holds all those
 * within \ref multiScaleMargin of it.
 * \param[in] settings with radii, and the engine that the whole cloud would use
 * \return with a shape for each point of the piece, in order
 * \throws std::invalid_argument without radii, or with a stop rule; Canceled */
MultiScaleShapes
pieceShapes(const Points& points,
            const CloudPiece& piece,
            const MultiScaleSettings& settings,
            ProgressMonitor* monitor = nullptr);

/** \brief How far around a piece its points must be known. */
double
multiScaleMargin(const std::vector<double>& radii);

} // namespace linelet
