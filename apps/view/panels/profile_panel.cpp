// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "profile_panel.h"

#include "model/profiles.h"
#include "panel_colors.h"

namespace linelet::view {

namespace {

QColor
colorOfWire(std::size_t i)
{
  static const QColor colors[] = {{0, 114, 178},
                                  {230, 159, 0},
                                  {0, 158, 115},
                                  {142, 94, 162},
                                  {86, 180, 233},
                                  {140, 109, 49}};
  return colors[i % 6];
}

} // namespace

ProfilePanel::ProfilePanel(const Model& model) : model_(model)
{
  x_title = "meters along the span";
  y_title = "height, m";
  empty_text = "Choose a wire in the table, or click one of its points: this shows its "
               "span from the side.";
}

void
ProfilePanel::refresh()
{
  clear();
  title.clear();
  const auto* network = model_.lines();
  if (network == nullptr || model_.wire() == 0)
    return update();
  const powerline::Wire& chosen =
      network->wires[static_cast<std::size_t>(model_.wire()) - 1];
  const SpanProfile profile = profileOf(model_.scene(), *network, chosen.span);
  const auto toLine = [](const std::vector<SpanProfile::Place>& places) {
    std::vector<QPointF> points;
    for (const auto& p : places)
      points.emplace_back(p.along, p.height);
    return points;
  };
  Line others, ground;
  others.color = QColor(168, 178, 166);
  others.width = 2;
  others.dots = true;
  others.points = toLine(profile.others);
  lines.push_back(others);
  ground.color = QColor(140, 112, 70);
  ground.points = toLine(profile.ground);
  lines.push_back(ground);
  for (std::size_t i = 0; i < profile.wires.size(); ++i) {
    const SpanProfile::Wire& wire = profile.wires[i];
    const bool is_chosen = wire.id == model_.wire();
    Line points, curve;
    points.color = faded(colorOfWire(i), is_chosen ? 255 : 130);
    points.width = is_chosen ? 4 : 2.5;
    points.dots = true;
    points.points = toLine(wire.points);
    if (is_chosen)
      curve.name = QString("wire %1").arg(wire.id);
    curve.color = is_chosen ? QColor(230, 20, 140) : colorOfWire(i);
    curve.width = is_chosen ? 2.5 : 1.2;
    curve.points = toLine(wire.curve);
    lines.push_back(std::move(points));
    lines.push_back(std::move(curve));
  }
  for (const SpanProfile::Measure& measure : profile.clearances) {
    if (measure.wire != model_.wire())
      continue;
    Line line;
    line.name = QString("%1 m to %2")
                    .arg(measure.distance, 0, 'f', 2)
                    .arg(measure.to_ground ? "ground" : "objects");
    line.color = measure.distance < model_.settings.wires.clearance ? red : dark;
    line.style = Qt::DashLine;
    line.points = {{measure.from.along, measure.from.height},
                   {measure.to.along, measure.to.height}};
    lines.push_back(std::move(line));
  }
  title = QString("span %1: %2 m, wire %3, confidence %4")
              .arg(profile.span)
              .arg(profile.length, 0, 'f', 1)
              .arg(chosen.id)
              .arg(chosen.confidence, 0, 'f', 2);
  fitRange();
  update();
}

} // namespace linelet::view
