// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "error_panel.h"

#include <algorithm>

#include <bench/measures/vertex_errors.h>

#include "panel_colors.h"

namespace linelet::view {

ErrorPanel::ErrorPanel(const Model& model) : model_(model)
{
  x_title = "along the curve, unit of the file";
  y_title = "distance (unit) and angle (90° = full height)";
  empty_text = "Open true curves with --truth FILE, and choose a curve: this shows its "
               "distance from them, and the angle between the tangents.";
}

void
ErrorPanel::refresh()
{
  clear();
  title.clear();
  const CurveNetwork& curves = model_.curves();
  const CurveNetwork& truth = model_.scene().truth;
  const auto chosen = static_cast<std::size_t>(model_.curve);
  if (truth.curves.empty() || model_.curve < 0 || chosen >= curves.curves.size())
    return update();
  const std::vector<bench::VertexError> errors =
      vertexErrors(curves.curves[chosen], bench::SegmentTree(truth));
  double most = 0, sum = 0;
  for (const bench::VertexError& e : errors) {
    most = std::max(most, e.distance);
    sum += e.distance;
  }
  Line distance, angle;
  distance.name = "distance";
  distance.color = yellow;
  distance.width = 2;
  angle.name = QString("angle, %1 = 90°").arg(most, 0, 'g', 3);
  angle.color = spherical_color;
  for (const bench::VertexError& e : errors) {
    distance.points.emplace_back(e.along, e.distance);
    angle.points.emplace_back(e.along, e.angle / 90 * (most > 0 ? most : 1));
  }
  title = QString("curve %1 of %2: mean distance %3, largest %4")
              .arg(chosen + 1)
              .arg(curves.curves.size())
              .arg(sum / static_cast<double>(std::max<std::size_t>(errors.size(), 1)),
                   0,
                   'g',
                   3)
              .arg(most, 0, 'g', 3);
  lines.push_back(std::move(distance));
  lines.push_back(std::move(angle));
  fitRange();
  update();
}

} // namespace linelet::view
