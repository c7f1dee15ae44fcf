// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/refined_reconstruction.h>

#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <linelet/curves/curve_blocks.h>
#include <linelet/search/scale_unit.h>
#include <linelet/search/subset_search.h>
#include <linelet/support/text.h>

#include "component_curves.h"
#include "curves/cloud_kind.h"
#include "curves/network/model_network.h"
#include "curves/parts/curves_by_blocks.h"
#include "curves/parts/whole_as_part.h"
#include "curves/ridges/distinct_points.h"
#include "curves/tracking/mixed_cloud.h"
#include "curves/tracking/mixed_reconstruction.h"

namespace linelet {

namespace {

// A cloud that is small, or linear around this share of its points, may consist of
// curves that are noisy for their extent; it does if curves explain this share.
constexpr double least_explained = 0.5;
// Curves closer to their points than this, in mean distances along them, blur nothing.
// Curves thinner by this factor, with this many times the evidence needed, do not arise
// by chance.
constexpr double sharp = 0.1, blurred = 10, certain = 5;
// A cloud that extends over more than this many D is a scene, not a shape whose noise
// may vary.
constexpr double scene_extent = 150;

/** \brief Number of points that \a curves explain. */
double
explainedBy(const ModelCurves& curves)
{
  double sum = 0;
  for (const ModelCurve& curve : curves)
    sum = std::accumulate(curve.counts.begin(), curve.counts.end(), sum);
  return sum;
}

/** \brief Mean distance of the points of \a curves from them, in mean distances of the
 * points along them. */
double
thicknessOf(const ModelCurves& curves)
{
  double sum = 0, points = 0;
  for (const ModelCurve& curve : curves) {
    const double own = explainedBy({curve});
    const double extent = length(curve);
    sum += extent > 0 ? own * curve.noise * own / extent : 0;
    points += own;
  }
  return points > 0 ? sum / points : 0;
}

/** \brief Whether \a mixed, a few thin curves, describe a cloud better than \a alone,
 * which explain all of it: some are certain, and \a alone blur them. */
bool
standOut(const ModelCurves& mixed, const ModelCurves& alone, double points)
{
  ModelCurves sure;
  for (const ModelCurve& curve : mixed)
    if (curve.evidence > certain * evidenceNeeded(points) &&
        thicknessOf({curve}) < sharp)
      sure.push_back(curve);
  return !sure.empty() && blurred * thicknessOf(sure) < thicknessOf(alone);
}

/** \brief \a known if these are set; otherwise the traits of \a points, all
 * distinct. */
CloudTraits
traitsOf(const Points& points,
         const NeighborSearch* search,
         const CloudTraits& known,
         unsigned threads)
{
  if (known.points > 0)
    return known;
  CloudTraits traits;
  traits.points = static_cast<double>(points.size());
  Eigen::AlignedBox3d box;
  for (const Point& p : points)
    box.extend(p);
  if (!box.isEmpty()) {
    traits.low = box.min();
    traits.high = box.max();
  }
  traits.scale_unit = search != nullptr ? scaleUnit(*search, points, 1024, 1, threads)
                                        : scaleUnit(points, 1024, 1, threads);
  if (hasScale(traits))
    traits.linear_share =
        isSmall(traits) ? 1 : linearShare(points, traits.scale_unit, threads);
  return traits;
}

CurveNetwork
reconstruct(const Points& all,
            const NeighborSearch* search,
            RefinedSettings settings,
            ProgressMonitor* monitor)
{
  if (!(settings.distance_cutoff >= 0))
    throw std::invalid_argument(
        "distance cutoff " + textOf(settings.distance_cutoff) +
        " is negative or not a number; 0 lets the method choose");
  const Indices different = distinct(all);
  const Points points = pointsAt(all, different);
  std::optional<SubsetSearch> subset;
  if (search != nullptr && points.size() < all.size())
    search = &subset.emplace(*search, all, different);
  const CloudTraits traits = traitsOf(points, search, settings.whole, settings.threads);
  if (!hasScale(traits) || points.empty())
    return {};
  settings.whole = traits;
  const double scale_unit = traits.scale_unit;
  ModelCurves curves;
  const bool alone_first = isSmall(traits) || isOfCurvesAlone(traits);
  const std::size_t blocks = CurveBlocks(traits).count();
  if (blocks > 1) {
    CurveNetwork network = curvesByBlocks(points, settings, monitor);
    if (!network.curves.empty() || traits.linear_share < least_explained)
      return network;
  }
  else if (!alone_first)
    curves = mixedCurves(points, scale_unit, settings, monitor);
  // Curves too noisy to be followed may still make up most of a cloud.
  if (alone_first || (curves.empty() && traits.linear_share >= least_explained)) {
    const Indices kept = thinned(points, scale_unit);
    std::optional<SubsetSearch> thin;
    if (search != nullptr && kept.size() < points.size())
      search = &thin.emplace(*search, points, kept);
    curves =
        componentCurves(pointsAt(points, kept), search, scale_unit, settings, monitor);
  }
  const double explained = explainedBy(curves);
  const bool little = explained < least_explained * static_cast<double>(points.size());
  const auto isScene = [&] {
    return (traits.high - traits.low).norm() > scene_extent * scale_unit ||
           (!isTiny(traits) &&
            linearShare(points, scale_unit, settings.threads) < curves_alone);
  };
  const bool is_scene = isSmall(traits) && thicknessOf(curves) > sharp && isScene();
  if (is_scene || (isSmall(traits) && little)) {
    ModelCurves mixed = mixedCurves(points, scale_unit, settings, monitor);
    if ((little && explainedBy(mixed) > explained) ||
        (is_scene && standOut(mixed, curves, traits.points)))
      curves = std::move(mixed);
  }
  return networkOf(curves);
}

} // namespace

CloudTraits
cloudTraits(const Points& points, unsigned threads)
{
  return traitsOf(pointsAt(points, distinct(points)), nullptr, {}, threads);
}

CurveNetwork
reconstructRefined(const Points& points,
                   const RefinedSettings& settings,
                   ProgressMonitor* monitor)
{
  return reconstruct(points, nullptr, settings, monitor);
}

CurveNetwork
reconstructRefined(const NeighborSearch& search,
                   const Points& points,
                   const RefinedSettings& settings,
                   ProgressMonitor* monitor)
{
  return reconstruct(points, &search, settings, monitor);
}

CurvePart
curvesOfBlock(const Points& points,
              std::size_t block,
              const RefinedSettings& settings,
              ProgressMonitor* monitor)
{
  const CurveBlocks blocks(settings.whole);
  return blocks.count() > 1
             ? ownCurves(points, blocks, block, settings, monitor)
             : wholeAsPart(reconstructRefined(points, settings, monitor));
}

} // namespace linelet
