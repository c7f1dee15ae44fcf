// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <linelet/curves/integration_scheme.h>
#include <linelet/features/centroid_shift.h>
#include <linelet/features/multi_scale_settings.h>
#include <linelet/support/names.h>
#include <linelet/support/points.h>
#include <linelet/support/visibility.h>
#include <linelet/tensor/neighborhood_tensor.h>
#include <linelet/tensor/weighting.h>

namespace LINELET_PUBLIC linelet {

/** \brief Where the direction of a step comes from. d_E is the interpolated
 * eigenvector, d_A the mean of the directions toward the neighbors ahead. */
enum class DirectionMode {
  Eigenvector,                ///< d_E
  Tensor,                     ///< major eigenvector of the interpolated tensor
  Angular,                    ///< d_A
  EigenvectorAngular,         ///< mu d_E + (1 - mu) d_A
  EigenvectorAngularDistance, ///< the same, d_A weighted by distance as well
  TensorDeflection,           ///< interpolated tensor times last direction (TEND)
  ClosestAngular,             ///< mu e3 + (1 - mu) d_A, e3 of the nearest point
  MultiScaleAngular, ///< the same with the multi-scale feature of the position itself,
                     ///< mu included, recomputed at every step
  ComputedAngular ///< the same with e3 of the position itself at the optimal radius of
                  ///< the nearest point
};

template <>
struct Names<DirectionMode> {
  static constexpr std::string_view kind = "direction mode";
  static constexpr std::array<std::pair<DirectionMode, std::string_view>, 9> table = {
      {{DirectionMode::Eigenvector, "eigenvector"},
       {DirectionMode::Tensor, "tensor"},
       {DirectionMode::Angular, "angular"},
       {DirectionMode::EigenvectorAngular, "eigenvector+angular"},
       {DirectionMode::EigenvectorAngularDistance, "eigenvector+angular-distance"},
       {DirectionMode::TensorDeflection, "tensor-deflection"},
       {DirectionMode::ClosestAngular, "closest+angular"},
       {DirectionMode::MultiScaleAngular, "multi-scale+angular"},
       {DirectionMode::ComputedAngular, "computed+angular"}}};
};

/** \brief The largest scale of the published method and of its faster variant, in D. */
constexpr double published_largest_radius = 60, quick_largest_radius = 10;

/** \brief Parameters of the published method (Ritter, Schiffner, Harders 2021). D is
 * the scale unit of the cloud, h the step length. */
struct StreamlineSettings {
  // Parameters for users; 0 lets the method choose.
  unsigned start_points = 0;   ///< number of line-lets; 0: by start_threshold
  unsigned max_iterations = 0; ///< steps of each end of a line-let; 0: enough to cross
                               ///< the cloud's bounding box four times
  double distance_cutoff = 0;  ///< a line-let ends farther than this from every point;
                               ///< 0: 2 D

  Indices starts; ///< points at which line-lets start, by index; empty: by score
  /// The only direction (x, y, z) in which line-lets grow from their starts (Ritter &
  /// Benger 2012); empty: both ways.
  std::vector<double> seed_direction;
  IntegrationScheme scheme = IntegrationScheme::Rk32;
  double tolerance = 1e-3; ///< in D: largest error of a step of the adaptive scheme
  DirectionMode direction = DirectionMode::EigenvectorAngular;
  MultiScaleSettings shape; ///< features of the points, with weighted-mean centroid
  /// Point of reference of the shapes by which start points are scored: as published,
  /// always the points themselves, whatever the centroid of the features.
  Centroid start_centroid = Centroid::QueryPoint;
  Weighting interpolation_weighting = Kernel::FermiDirac2; ///< w_I
  Weighting angle_weighting = Kernel::FermiDirac2;         ///< w_A
  /// Whether d_E has length 1. As published (eq. 4) it is shorter where the neighbors
  /// disagree, so that d_A counts more there.
  bool unit_eigenvector = false;
  /// In D: largest scale, where shape.max_radius is 0; 0: published_largest_radius.
  double largest_radius = 0;
  double interpolation_radius = 2.5; ///< in D; 0: optimal radius of the nearest point
  double step = 0.5;                 ///< h, in D
  /// In D: largest distance of the nearest point, which gives mu
  double search_radius = 1.25;
  double merge_distance = 1.4; ///< in h: ends meet, lines cross
  double branch_angle = 70; ///< degrees: a sharper turn ends a line-let, starts another
  double prune_distance = 1.2; ///< in h: open ends are cut back to the points
  /// Where start_points is 0: starts are taken while their score exceeds this fraction
  /// of the second one's (the score of the first has another unit, as its distance is
  /// set to 1).
  double start_threshold = 0.2;
  /// In D: points farther than this from every line-let start additional ones; 0: none
  double cover_distance = 8;
  double stump_length = 4; ///< in h: shorter loose ends and pieces are dropped
  /// Number of points considered as starts, drawn at random with shape.scale_unit_seed;
  /// 0: all (the thesis' StartPointsLimit).
  std::size_t start_candidates = 0;
  /// Smallest N1 of a start point, unless no point has as many
  unsigned min_start_neighbors = 6;
  /// Exponent of N1 in the score of start points. On 330 runs of the benchmark (seed
  /// 11), 0.01 succeeds in .321 and 1 in .339, with a mean E_V of .438 and .447. 12
  /// runs differ in success, 9 of them in favor of 1: within chance (p = .15), so the
  /// published value stays.
  double start_neighbor_exponent = 0.01;
  /// A tensor for every point, for example of a diffusion tensor image: its eigenvector
  /// e3 is followed, and no shapes are measured; empty: those of the points. Direction
  /// modes that recompute shapes at every step do not work with it.
  std::vector<SymmetricTensor> tensors;
  CentroidShiftSettings prefilter; ///< applied to the points before all this
  unsigned threads = 0;            ///< 0: all

  StreamlineSettings() { shape.centroid = Centroid::WeightedMean; }
};

template <class Visit>
void
describe(StreamlineSettings& s, Visit&& visit)
{
  visit("start-points", s.start_points, "number of start points; 0: as many as needed");
  visit("max-iterations", s.max_iterations, "steps per trace; 0: automatic");
  visit("distance-cutoff",
        s.distance_cutoff,
        "widest gap to bridge, in the unit of the cloud; 0: automatic");
  visit(
      "start", s.starts, "published: points to start at, by index in the file, from 0");
  visit("seed-direction",
        s.seed_direction,
        "published: grow curves from their starts in direction X,Y,Z only");
  visit("scheme", s.scheme, "published: integration scheme");
  visit("tolerance", s.tolerance, "published: largest error of an adaptive step, in D");
  visit("direction", s.direction, "published: where a step's direction comes from");
  visit("start-centroid",
        s.start_centroid,
        "published: point of reference for the scores of start points");
  visit("unit-eigenvector",
        s.unit_eigenvector,
        "published: give the interpolated eigenvector length 1");
  visit("interpolation-weight",
        s.interpolation_weighting,
        "published: weighting kernel w_I of the interpolation");
  visit("angle-weight",
        s.angle_weighting,
        "published: weighting kernel w_A of the angles");
  visit(
      "largest-radius",
      s.largest_radius,
      "published: largest scale in D, unless --max-radius is given; 0: 60, or 10 with "
      "--preset published-quick");
  visit("interpolation-radius",
        s.interpolation_radius,
        "published: radius of the interpolation, in D; 0: the optimal radius of the "
        "nearest point");
  visit("step", s.step, "published: step length h, in D");
  visit("search-radius",
        s.search_radius,
        "published: how far the nearest point may be, in D");
  visit("merge-distance",
        s.merge_distance,
        "published: distance at which ends meet, in h");
  visit("branch-angle",
        s.branch_angle,
        "published: a sharper turn starts a branch, degrees");
  visit("prune-distance",
        s.prune_distance,
        "published: open ends are cut back until a point is this near, in h");
  visit("start-threshold",
        s.start_threshold,
        "published: without --start-points, take starts whose score exceeds this "
        "fraction of the second one's");
  visit("cover-distance",
        s.cover_distance,
        "published: without --start-points, start more curves at points farther "
        "than this from every curve, in D; 0: none");
  visit("stump-length",
        s.stump_length,
        "published: drop loose pieces shorter than this, in h");
  visit("start-candidates",
        s.start_candidates,
        "published: number of random points to consider as starts; 0: all");
  visit("min-start-neighbors",
        s.min_start_neighbors,
        "published: number of neighbors that a start point needs");
  visit("start-neighbor-exponent",
        s.start_neighbor_exponent,
        "published: exponent of the number of neighbors in the score of start points");
  describe(s.prefilter,
           "prefilter-radius",
           "prefilter-",
           [&](const char* name, auto& value, const char* help) {
             visit(name, value, (std::string("published: ") + help).c_str());
           });
  describe(s.shape, [&](const char* name, auto& value, std::string help) {
    // If it is 0, largest_radius takes its place.
    if (std::string_view(name) == "max-radius")
      help = "largest radius, in the unit of the cloud; 0: --largest-radius";
    visit(name, value, ("published: " + help).c_str());
  });
}

/** \brief Checks that every parameter is in range.
 * \throws std::invalid_argument naming the parameter, its value and its range */
void
validate(const StreamlineSettings& settings);

} // namespace linelet
