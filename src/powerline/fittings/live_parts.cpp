// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/fittings/live_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <linelet/support/threads.h>
#include <linelet/tensor/eigen_analysis.h>
#include <linelet/tensor/neighborhood_tensor.h>

#include "support/parallel_failure.h"

namespace linelet::powerline {

namespace {

constexpr std::size_t fewest_of_body = 5; // points of a body, and of a shape

// The direction at every point with thin surroundings; otherwise 0.
Points
findThin(const SupportSite& site, const FittingPriors& priors, unsigned threads)
{
  Points thin(site.points.size(), Point::Zero());
  const auto count = static_cast<std::ptrdiff_t>(site.points.size());
  ParallelFailure failure;
#pragma omp parallel for schedule(dynamic, 256) num_threads(threadCount(threads))
  for (std::ptrdiff_t k = 0; k < count; ++k)
    failure.guard([&] {
      Points near;
      Point sum = Point::Zero();
      const auto i = static_cast<std::size_t>(k);
      site.grid->forEachOffsetWithin(
          site.points[i], priors.air_gap, [&](const Point& offset, double) {
            near.push_back(offset);
            sum += offset;
          });
      if (near.size() < fewest_of_body)
        return;
      const EigenSystem axes = eigenAnalysis(neighborhoodTensor(
          near, sum / static_cast<double>(near.size()), priors.air_gap, Kernel::Const));
      const double ratio = std::sqrt(axes.values[1] / axes.values[2]);
      if (ratio <= priors.thin())
        thin[i] = axes.major();
    });
  failure.rethrow();
  return thin;
}

// Whether a thin point in the tube of a wire is the tip of an arm or peak that the
// wire, or its string, is fixed to: it runs across the wire, not up from it.
bool
isTip(const SupportSite& site, Index i, const Point& direction, double reach)
{
  constexpr double across = 0.7; // cosine of 45 degrees
  if (site.tube[i] < 0 || site.along[i] > reach)
    return false;
  const WireEnd& end = site.ends[static_cast<std::size_t>(site.tube[i])];
  const Point place = end.at(site.along[i]);
  const Point course = (end.at(site.along[i] + 1) - place).normalized();
  return std::abs(direction.dot(course)) < across && site.points[i].z() <= place.z();
}

} // namespace

void
findLiveParts(SupportSite& site, const FittingPriors& priors, unsigned threads)
{
  site.direction = findThin(site, priors, threads);
  const Points& thin = site.direction;
  site.earthed.assign(site.points.size(), 0);
  const auto isBulky = [&](Index i) {
    return thin[i].isZero() || isTip(site, i, thin[i], priors.air_gap);
  };
  for (const Indices& body : bodiesOf(site, priors.link(), isBulky)) {
    Point low = site.points[body.front()], high = low;
    for (const Index i : body) {
      low = low.cwiseMin(site.points[i]);
      high = high.cwiseMax(site.points[i]);
    }
    if ((high - low).maxCoeff() > priors.bulky)
      for (const Index i : body)
        site.earthed[i] = 1;
  }
  site.live.assign(site.points.size(), 0);
  for (const Indices& body :
       bodiesOf(site, priors.link(), [&](Index i) { return site.earthed[i] == 0; })) {
    const auto of_wires =
        static_cast<std::size_t>(std::count_if(body.begin(), body.end(), [&](Index i) {
          return site.tube[i] >= 0 && site.along[i] > priors.air_gap;
        }));
    if (of_wires >= fewest_of_body)
      for (const Index i : body)
        site.live[i] = 1;
  }
}

} // namespace linelet::powerline
