// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include <linelet/features/score_weights.h>
#include <linelet/support/names.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief How the terms of a maximum's score O_m are combined.
 *
 * It hardly matters: the published reconstruction on the same 400 runs of the benchmark
 * grid succeeds in .325 of them with Product and in .315 with Sum (one standard error
 * is .023). */
enum class ScaleScore {
  Product, ///< (1 - k/K) CL_j + A_j/A - delta/2 (Ritter, Schiffner, Harders 2021, eq.
           ///< 9)
  Sum      ///< (CL_j - k/K) + A_j/A - delta/2 (the thesis' Appendix A.2)
};

template <>
struct Names<ScaleScore> {
  static constexpr std::string_view kind = "scale score";
  static constexpr std::array<std::pair<ScaleScore, std::string_view>, 2> table = {
      {{ScaleScore::Product, "product"}, {ScaleScore::Sum, "sum"}}};
};

/** \brief The variable over which the areas A and A_j under the graph are taken.
 *
 * On the same 400 runs as for ScaleScore: success .325 with Scales, .323 with
 * LogRadius, .320 with Radius, the mean distance from the curve .404, .393 and .431; no
 * difference beyond noise. */
enum class GraphIntegral {
  Scales,    ///< plain sum over the scales
  LogRadius, ///< integral over ln r (trapezoids)
  Radius     ///< integral over r (trapezoids), in units of length
};

template <>
struct Names<GraphIntegral> {
  static constexpr std::string_view kind = "graph integral";
  static constexpr std::array<std::pair<GraphIntegral, std::string_view>, 3> table = {
      {{GraphIntegral::Scales, "scales"},
       {GraphIntegral::LogRadius, "log-radius"},
       {GraphIntegral::Radius, "radius"}}};
};

/** \brief Where the area A under a graph ends (the thesis' MSSFFullIntegral). */
enum class AreaEnd {
  LastMinimum, ///< at the last local minimum, where there is one
  WholeGraph   ///< at the largest radius
};

template <>
struct Names<AreaEnd> {
  static constexpr std::string_view kind = "area end";
  static constexpr std::array<std::pair<AreaEnd, std::string_view>, 2> table = {
      {{AreaEnd::LastMinimum, "last-minimum"}, {AreaEnd::WholeGraph, "whole-graph"}}};
};

/** \brief How the blend mu of a direction is computed, clamped to [0.05, 0.95]. The
 * thesis names seven variants but gives no formulas for the rest. */
enum class BlendMode {
  Published, ///< A_j / (2 A) + CL_j - 1/2 (eq. 10)
  Integral,  ///< A_j / A
  Sum,       ///< A / K, the mean linearity of all scales
  Linearity, ///< CL_j
  Index      ///< 1 - k_j / K
};

template <>
struct Names<BlendMode> {
  static constexpr std::string_view kind = "blend";
  static constexpr std::array<std::pair<BlendMode, std::string_view>, 5> table = {
      {{BlendMode::Published, "published"},
       {BlendMode::Integral, "integral"},
       {BlendMode::Sum, "sum"},
       {BlendMode::Linearity, "linearity"},
       {BlendMode::Index, "index"}}};
};

/** \brief How a linearity graph is read. */
struct LinearityGraphSettings {
  ScaleScore score = ScaleScore::Product;
  ScoreWeights score_weights;
  GraphIntegral integral = GraphIntegral::Scales;
  AreaEnd area_end = AreaEnd::LastMinimum;
  /// Smallest neighborhood whose scale may become the optimal one, including the point
  /// itself: the ball of radius D has a median of 7.
  unsigned min_neighbors = 7;
  BlendMode blend = BlendMode::Published;
};

template <class Visit>
void
describe(LinearityGraphSettings& s, Visit&& visit)
{
  visit(
      "scale-score", s.score, "how the terms of a local maximum's score are combined");
  visit(
      "score-weights",
      s.score_weights,
      "factors of the terms of that score, NAME=VALUE,... of linearity (published 1), "
      "scale (-1), area (1), depth (-0.5), step, width, neighbors and second (0)");
  visit("graph-integral", s.integral, "variable of the area under the linearity graph");
  visit("area-end", s.area_end, "where that area ends");
  visit("min-neighbors",
        s.min_neighbors,
        "smallest neighborhood of an optimal scale, including the point itself");
  visit("blend", s.blend, "how the blend of the optimal scale is computed");
}

/** \brief A local maximum of a linearity graph. Scales count from 0. */
struct GraphMaximum {
  std::size_t scale;    ///< k_j; on a plateau its first scale with enough neighbors
  std::size_t left;     ///< j-: nearest local minimum below, or where the graph begins
  std::size_t right;    ///< j+: nearest local minimum above, or where the graph ends
  double area_fraction; ///< A_j / A, clamped to [0, 1]
  double delta;         ///< CL_j - max(CL_j-, CL_j+)
  double score;         ///< O_m
};

/** \brief Results of the linearity graph of one point (Ritter, Schiffner and
 * Harders 2021, section 5). */
struct LinearityGraph {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::vector<GraphMaximum> maxima; ///< by scale; scales with enough neighbors only
  std::vector<std::size_t> minima;  ///< by scale; a plateau counts as its last scale
  double area = 0;                  ///< A, NaN where no scale is defined
  double largest = 0;               ///< CL_max, NaN where no scale is defined
  std::size_t best = none;          ///< index in \ref maxima of the best score
  double blend = 0;                 ///< mu in [0.05, 0.95], NaN without a maximum

  /** \brief The optimal scale, or \ref none. */
  std::size_t
  scale() const
  {
    return best == none ? none : maxima[best].scale;
  }
};

/** \brief Linearities closer than this count as equal: rounding makes no extrema. */
constexpr double flat_linearity = 1e-6;

} // namespace linelet
