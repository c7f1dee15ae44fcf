// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tensor_among_files.h"

#include <algorithm>
#include <limits>

#include <linelet/features/tensor_estimation.h>
#include <linelet/search/kd_tree.h>

#include "tensor_estimate.h"

namespace linelet::apps {

namespace {

/** \brief Upper bound of the distance of nearest points beyond the box of \a points:
 * the distance within which these alone suffice. */
double
nearestMargin(const Points& points,
              const TensorSettings& settings,
              const NeighborhoodSizes& sizes)
{
  constexpr double everywhere = std::numeric_limits<double>::infinity();
  const KdTree tree(points);
  Point low = Point::Constant(everywhere), high = -low;
  for (const Point& point : points)
    if (point.allFinite()) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
  double margin = 0;
  Indices found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite())
      continue;
    const std::size_t k = settings.k > 0 ? settings.k : sizes.counts[i];
    const double radius = tree.nearest(points[i], k, found);
    if (found.size() < k)
      return everywhere;
    const double depth =
        std::min((points[i] - low).minCoeff(), (high - points[i]).minCoeff());
    margin = std::max(margin, radius - depth);
  }
  return margin * (1 + 1e-9); // a point exactly at the distance counts
}

} // namespace

std::vector<PointDistributionTensor>
estimateAmongOthers(CloudInput& input,
                    std::size_t number,
                    const io::Cloud& cloud,
                    const io::UsablePoints& usable,
                    TensorSettings& settings,
                    NeighborFinder& finder,
                    const SizeFields& fields,
                    Frame& frame)
{
  std::vector<double> values;
  if (!fields.name().empty())
    values = valuesOf(cloud, fields.name(), input.files()[number]);
  const NeighborhoodSizes own = sizesFrom(values, fields);
  if (input.files().size() == 1)
    return estimate(usable.points(), settings, finder, own, frame);

  validate(settings, own, cloud.points.size());
  const bool nearest = settings.k > 0 || !own.counts.empty();
  const double margin = nearest ? nearestMargin(usable.points(), settings, own)
                                : tensorMargin(settings, own);
  const CloudInput::Surroundings all =
      input.surroundings(number, cloud, usable, margin, fields.name());
  const NeighborhoodSizes sizes = sizesFrom(all.values, fields);
  if (finder.engine == EngineOption::Auto) {
    // The engine that all files together would use on the processor.
    EngineWork work = engineWork(all.points, all.points, settings, sizes);
    work.points = work.queries = 0;
    for (const io::FileSummary& file : input.summaries())
      work.points = work.queries += file.points;
    finder.engine = optionOf(cheapestEngine(work));
  }
  announceTensors(all.points, settings, finder, sizes, frame);
  if (!finder.takesPieces()) {
    const std::vector<PointDistributionTensor> records =
        tensorsWith(finder, all.points, all.points, settings, sizes, frame);
    return {records.begin() + static_cast<std::ptrdiff_t>(all.piece.begin),
            records.begin() + static_cast<std::ptrdiff_t>(all.piece.end)};
  }
  settings.engine = finder.onProcessor();
  return pieceTensors(all.points, all.piece, settings, sizes, &frame.monitor);
}

} // namespace linelet::apps
