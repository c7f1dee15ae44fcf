// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tensor_tally.h"

#include <cmath>
#include <cstdio>

#include <linelet/search/scale_unit.h>

namespace linelet::apps {

Tally
tallyOf(const std::vector<PointDistributionTensor>& records, std::size_t left_out)
{
  Tally tally;
  tally.points = records.size();
  tally.left_out = left_out;
  double neighbors = 0;
  for (const PointDistributionTensor& record : records) {
    tally.unknown += std::isnan(record.linearity) ? 1 : 0;
    neighbors += record.neighbors;
  }
  tally.unknown -= left_out;
  if (tally.points > left_out)
    tally.mean_neighbors = neighbors / static_cast<double>(tally.points - left_out);
  return tally;
}

void
print(const Tally& tally,
      const std::string& file,
      const TensorSettings& settings,
      const NeighborFinder& finder,
      const SizeFields& fields)
{
  std::printf("%s: %zu points, %s, %.1f neighbors on average, %s %s\n",
              file.c_str(),
              tally.points,
              describeSize(settings, fields).c_str(),
              tally.mean_neighbors,
              isOfPcl(finder.search) ? "search" : "engine",
              finder.name().c_str());
}

void
printUnknown(const Tally& tally)
{
  if (tally.unknown > 0)
    std::printf("%zu points have no shape: too few neighbors, or all coincident\n",
                tally.unknown);
}

void
printUnknown(const Tally& tally, double scale_unit, const Points& points)
{
  printUnknown(tally);
  // One point in a hundred does not justify another radius.
  if (tally.unknown * 100 <= tally.points - tally.left_out)
    return;
  if (std::isnan(scale_unit))
    scale_unit = scaleUnit(points);
  if (scale_unit > 0)
    std::printf("try --radius %.3g: three times the scale unit of this cloud\n",
                radiusFor(scale_unit));
}

void
summarize(nlohmann::ordered_json& summary,
          const Tally& tally,
          const TensorSettings& settings,
          const NeighborFinder& finder,
          const SizeFields& fields)
{
  summary["points"] = tally.points;
  if (settings.radius > 0)
    summary["radius"] = settings.radius;
  if (settings.k > 0)
    summary["knn"] = settings.k;
  if (!fields.radius.empty())
    summary["radius_field"] = fields.radius;
  if (!fields.knn.empty())
    summary["knn_field"] = fields.knn;
  summary["weight"] = settings.weighting.name();
  summary["centroid"] = nameOf(settings.centroid);
  summary["engine"] = finder.name();
  summary["mean_neighbors"] = tally.mean_neighbors;
  summary["unknown"] = tally.unknown;
}

} // namespace linelet::apps
