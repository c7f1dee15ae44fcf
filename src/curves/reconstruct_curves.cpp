// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/curves/reconstruct_curves.h>

#include <linelet/curves/refined_reconstruction.h>
#include <linelet/curves/streamline_reconstruction.h>

namespace linelet {

CurveNetwork
reconstructCurves(const Points& points,
                  const ReconstructionSettings& settings,
                  ProgressMonitor* monitor)
{
  validate(settings);
  if (settings.preset == Preset::Published)
    return reconstructPublished(points, settings, monitor);
  RefinedSettings refined;
  refined.start_points = settings.start_points;
  refined.max_iterations = settings.max_iterations;
  refined.distance_cutoff = settings.distance_cutoff;
  refined.threads = settings.threads;
  return reconstructRefined(points, refined, monitor);
}

} // namespace linelet
