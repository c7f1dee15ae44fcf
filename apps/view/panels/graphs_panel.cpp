// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "graphs_panel.h"

#include <algorithm>

#include "panel_colors.h"

namespace linelet::view {

GraphsPanel::GraphsPanel(const Model& model) : model_(model)
{
  x_title = "radius, unit of the file";
  y_title = "shape factor";
  log_x = true;
  empty_text =
      "Click a point of the cloud: this shows how linear, planar and spherical "
      "its neighborhood is at every radius, and which radius is optimal.";
}

void
GraphsPanel::refresh()
{
  clear();
  title.clear();
  const PointGraphs* graphs = model_.graphs();
  if (graphs == nullptr)
    return update();
  const std::vector<double>& radii = graphs->radii;
  const QColor colors[] = {linear_color, planar_color, spherical_color};
  const char* names[] = {"linearity", "planarity", "sphericity"};
  for (std::size_t factor = 0; factor < 3; ++factor) {
    Band band;
    band.color = faded(colors[factor], 45);
    Line line;
    line.name = names[factor];
    line.color = colors[factor];
    line.width = 2;
    for (std::size_t k = 0; k < radii.size(); ++k) {
      const ScaleShape& s = graphs->graph[k];
      const float value = factor == 0   ? s.linearity
                          : factor == 1 ? s.planarity
                                        : s.sphericity;
      line.points.emplace_back(radii[k], static_cast<double>(value));
      if (k < graphs->spread.size()) {
        const auto& spread = graphs->spread[k];
        band.low.emplace_back(radii[k], spread.mean[factor] - spread.deviation[factor]);
        band.high.emplace_back(radii[k],
                               spread.mean[factor] + spread.deviation[factor]);
      }
    }
    bands.push_back(std::move(band));
    lines.push_back(std::move(line));
  }
  for (const GraphMaximum& maximum : graphs->reading.maxima) {
    const bool own = maximum.scale == graphs->scale;
    marks.push_back(
        {radii[maximum.scale],
         own ? red : dark,
         (own ? QString("optimal radius %1, ").arg(radii[maximum.scale], 0, 'g', 4)
              : QString()) +
             QString("score %1").arg(maximum.score, 0, 'f', 3),
         own ? 2.5 : 1.5,
         std::clamp(maximum.score / 2, 0.1, 1.0)});
  }
  title = QString("point %1: lines are its own graphs (%2), bands its neighbors' mean "
                  "± standard deviation")
              .arg(*model_.selected())
              .arg(graphs->stored ? "as computed" : "engine sweep");
  if (graphs->scale == LinearityGraph::none)
    title = QString("point %1 has no optimal scale: too few neighbors")
                .arg(*model_.selected());
  const double last = radii.size() > 1 ? radii.back() : 2 * radii.front();
  setRange(radii.front(), last, 0, 1.02);
  update();
}

} // namespace linelet::view
