// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <stdexcept>

#include "cloud/cloud_view.h"
#include "controls.h"
#include "panels/error_panel.h"
#include "window.h"

namespace linelet::view {

void
Window::select(std::optional<Index> point)
{
  model.select(point);
  if (!point)
    return;
  const Point at = model.scene().cloud.points[*point] + model.scene().cloud.shift;
  say("point " + std::to_string(*point) + " at " +
      QString("%1 %2 %3")
          .arg(at.x(), 0, 'f', 2)
          .arg(at.y(), 0, 'f', 2)
          .arg(at.z(), 0, 'f', 2)
          .toStdString());
  const auto* network = model.lines();
  if (network != nullptr && *point < network->wire_id.size() &&
      network->wire_id[*point] > 0)
    selectWire(network->wire_id[*point], false);
}

void
Window::selectWire(int id, bool approach)
{
  if (id == model.wire())
    return;
  model.selectWire(id);
  const powerline::Wire& wire = model.lines()->wires[static_cast<std::size_t>(id) - 1];
  if (approach)
    cloud_view_->lookAt(model.toCloud((wire.front + wire.back) / 2),
                        std::max(0.6 * wire.span_length, 5.0));
  cloud_view_->showLines();
}

void
Window::selectCurve(int place)
{
  if (place < -1 || place >= static_cast<int>(model.curves().curves.size()))
    throw std::invalid_argument("there is no curve " + std::to_string(place) +
                                "; there are " +
                                std::to_string(model.curves().curves.size()));
  model.curve = place;
  cloud_view_->showLines();
  error_->refresh();
}

void
Window::previewAround(double half_width)
{
  if (!model.selected())
    return say("Click a point first: the box goes around it.", true);
  const Point at = model.scene().cloud.points[*model.selected()];
  const Point half = Point::Constant(half_width);
  preview(Box{at - half, at + half});
}

void
Window::preview(const std::optional<Box>& box)
{
  model.setPreview(box);
  controls_->refresh();
  cloud_view_->showSelection();
}

void
Window::beginLine()
{
  drawing_ = true;
  cloud_view_->drawn_line.clear();
  say("Click the vertices of the line; choose Draw a line again to end it.");
}

void
Window::endLine()
{
  drawing_ = false;
  if (cloud_view_->drawn_line.size() < 2)
    return say("A line needs at least two vertices.", true);
  model.imageAlong(cloud_view_->drawn_line);
  showPanel("image");
}

void
Window::imageAlongCurve()
{
  Points line;
  const CurveNetwork& curves = model.curves();
  if (model.wire() > 0)
    for (const Point& p : powerline::polyline(
             model.lines()->wires[static_cast<std::size_t>(model.wire()) - 1]))
      line.push_back(model.toCloud(p));
  else if (model.curve >= 0)
    line = curves.curves[static_cast<std::size_t>(model.curve)].points;
  if (line.size() < 2)
    return say("Choose a wire or a curve first: the image runs along it.", true);
  model.imageAlong(line);
  showPanel("image");
}

void
Window::imageAround()
{
  try {
    model.imageAround();
    showPanel("image");
  }
  catch (const std::exception& error) {
    say(error.what(), true);
  }
}

void
Window::clicked(const Ray& ray, double depth)
{
  const Scene& scene = model.scene();
  const Index found =
      scene.grid == nullptr ? UniformGrid::none : pick(*scene.grid, ray, depth);
  if (found == UniformGrid::none)
    return say("no point there");
  if (drawing_) {
    cloud_view_->drawn_line.push_back(scene.points[found]);
    cloud_view_->showSelection();
    return;
  }
  select(found);
}

} // namespace linelet::view
