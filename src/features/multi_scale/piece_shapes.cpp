// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstddef>
#include <stdexcept>

#include <features/multi_scale/multi_scale_grid.h>
#include <features/simd_grid/multi_scale/multi_scale_engine.h>
#include <linelet/features/multi_scale.h>

namespace linelet {

MultiScaleShapes
pieceShapes(const Points& points,
            const CloudPiece& piece,
            const MultiScaleSettings& settings,
            ProgressMonitor* monitor)
{
  checkRadii(settings.radii);
  if (settings.stop_change > 0)
    throw std::invalid_argument("the stop rule needs all points of a cloud, not a "
                                "piece; give the radii");
  const auto begin = static_cast<std::ptrdiff_t>(piece.begin),
             end = static_cast<std::ptrdiff_t>(piece.end);
  MultiScaleSettings chosen = settings;
  chosen.engine = chosenScaleEngine(points, points, settings.radii.back(), settings);
  MultiScaleShapes result;
  result.scale_unit = settings.scale_unit;
  result.radii = settings.radii;
  if (chosen.engine == ScaleEngine::Grid &&
      multiScaleShapesOnGrid(points, points, &piece, chosen, {}, monitor, result)) {
    result.shapes.resize(piece.end);
    result.shapes.erase(result.shapes.begin(), result.shapes.begin() + begin);
    return result;
  }
  chosen.engine = ScaleEngine::Sweep;
  return multiScaleShapes(points,
                          Points(points.begin() + begin, points.begin() + end),
                          chosen,
                          {},
                          monitor);
}

double
multiScaleMargin(const std::vector<double>& radii)
{
  return grid::multiScaleGridMargin(radii.back());
}

} // namespace linelet
