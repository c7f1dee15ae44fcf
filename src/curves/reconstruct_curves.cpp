// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/reconstruct_curves.h>

#include <linelet/curves/refined_reconstruction.h>
#include <linelet/curves/streamline_reconstruction.h>

namespace linelet {

namespace {

CurveNetwork
reconstruct(const NeighborSearch* search,
            const Points& points,
            ReconstructionSettings settings,
            ProgressMonitor* monitor)
{
  validate(settings);
  if (settings.preset == Preset::PublishedQuick && settings.largest_radius == 0)
    settings.largest_radius = quick_largest_radius;
  if (isPublished(settings.preset))
    return search != nullptr ? reconstructPublished(*search, points, settings, monitor)
                             : reconstructPublished(points, settings, monitor);
  const RefinedSettings refined = refinedSettings(settings);
  return search != nullptr ? reconstructRefined(*search, points, refined, monitor)
                           : reconstructRefined(points, refined, monitor);
}

} // namespace

RefinedSettings
refinedSettings(const ReconstructionSettings& settings)
{
  RefinedSettings refined;
  refined.start_points = settings.start_points;
  refined.max_iterations = settings.max_iterations;
  refined.distance_cutoff = settings.distance_cutoff;
  refined.threads = settings.threads;
  refined.whole = settings.whole;
  return refined;
}

CurveNetwork
reconstructCurves(const Points& points,
                  const ReconstructionSettings& settings,
                  ProgressMonitor* monitor)
{
  return reconstruct(nullptr, points, settings, monitor);
}

CurveNetwork
reconstructCurves(const NeighborSearch& search,
                  const Points& points,
                  const ReconstructionSettings& settings,
                  ProgressMonitor* monitor)
{
  return reconstruct(&search, points, settings, monitor);
}

} // namespace linelet
