// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "cloud_view.h"

#include <cmath>

#include <QMouseEvent>
#include <QTimer>
#include <QWheelEvent>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "camera.h"
#include "dots.h"
#include "overlays.h"

namespace linelet::view {

namespace {

constexpr std::size_t most_moving = 200000; ///< points drawn while the view moves

} // namespace

struct CloudView::Actors {
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window =
      vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
  vtkSmartPointer<vtkRenderer> renderer = vtkSmartPointer<vtkRenderer>::New();
  Dots all, part;
  Polylines curves{2}, chosen{5}, marks{2};
  Ellipsoids ellipsoids, own;
  bool moving = false;
};

CloudView::CloudView(const Model& model, QWidget* parent)
    : QVTKOpenGLNativeWidget(parent),
      model_(model),
      actors_(std::make_unique<Actors>()),
      camera_(std::make_unique<Camera>(*actors_->renderer, *this)),
      still_(new QTimer(this))
{
  actors_->renderer->SetBackground(0.97, 0.97, 0.98);
  for (vtkActor* actor : {actors_->all.actor.Get(),
                          actors_->part.actor.Get(),
                          actors_->curves.actor.Get(),
                          actors_->chosen.actor.Get(),
                          actors_->marks.actor.Get(),
                          actors_->ellipsoids.actor.Get(),
                          actors_->own.actor.Get()})
    actors_->renderer->AddActor(actor);
  actors_->ellipsoids.done();
  actors_->own.done();
  actors_->window->SetMultiSamples(0);
  actors_->window->AddRenderer(actors_->renderer);
  setRenderWindow(actors_->window);
  still_->setSingleShot(true);
  still_->setInterval(300);
  connect(still_, &QTimer::timeout, [this] { setMoving(false); });
  setMoving(false);
}

CloudView::~CloudView() = default;

void
CloudView::showScene()
{
  const Points& points = model_.scene().cloud.points;
  actors_->all.place(points, randomSubset(points.size(), points.size()));
  actors_->part.place(points, randomSubset(points.size(), most_moving));
  drawn_line.clear();
  showLines();
  showSelection();
  showAll();
}

void
CloudView::setColoring(const Coloring& coloring)
{
  if (coloring.rgb.size() == 3 * model_.scene().cloud.points.size()) {
    actors_->all.color(coloring.rgb);
    actors_->part.color(coloring.rgb);
  }
  actors_->window->Render();
}

void
CloudView::setPointSize(double pixels)
{
  for (Dots* dots : {&actors_->all, &actors_->part})
    dots->actor->GetProperty()->SetPointSize(static_cast<float>(pixels));
  actors_->window->Render();
}

void
CloudView::showLines()
{
  showCurves(model_, actors_->curves, actors_->chosen);
  actors_->window->Render();
}

void
CloudView::showSelection()
{
  view::showSelection(model_, drawn_line, actors_->marks, actors_->own);
  actors_->window->Render();
}

void
CloudView::showEllipsoids(bool everywhere)
{
  showTensors(model_, everywhere, actors_->ellipsoids);
  actors_->window->Render();
}

void
CloudView::look(double azimuth, double elevation)
{
  camera_->look(azimuth, elevation);
  moved();
}

void
CloudView::lookAt(const Point& place, double radius)
{
  camera_->lookAt(place, radius);
  moved();
}

void
CloudView::showAll()
{
  camera_->showAll(model_.scene().bounds);
  moved();
}

QPointF
CloudView::pixelOf(const Point& p) const
{
  return camera_->pixelOf(p);
}

std::pair<Ray, double>
CloudView::rayAt(QPointF pixel) const
{
  return camera_->rayAt(pixel, model_.scene().bounds);
}

void
CloudView::renderStill()
{
  still_->stop();
  setMoving(false);
}

void
CloudView::moved()
{
  actors_->renderer->ResetCameraClippingRange();
  setMoving(true);
  still_->start();
}

void
CloudView::setMoving(bool moving)
{
  // A small cloud is drawn whole all the time.
  actors_->moving =
      moving && actors_->all.indices.size() > actors_->part.indices.size();
  actors_->all.actor->SetVisibility(actors_->moving ? 0 : 1);
  actors_->part.actor->SetVisibility(actors_->moving ? 1 : 0);
  actors_->window->Render();
}

void
CloudView::mousePressEvent(QMouseEvent* event)
{
  pressed_ = last_ = event->pos();
  dragging_ = false;
}

void
CloudView::mouseMoveEvent(QMouseEvent* event)
{
  if (event->buttons() == Qt::NoButton)
    return;
  if (!dragging_ && (event->pos() - pressed_).manhattanLength() < 4)
    return;
  dragging_ = true;
  const QPoint step = event->pos() - last_;
  last_ = event->pos();
  const bool turns = (event->buttons() & Qt::LeftButton) != 0 &&
                     (event->modifiers() & Qt::ShiftModifier) == 0;
  if (turns)
    camera_->turn(step);
  else
    camera_->shift(step);
  moved();
}

void
CloudView::mouseReleaseEvent(QMouseEvent* event)
{
  if (!dragging_ && event->button() == Qt::LeftButton && on_click) {
    const auto [ray, depth] = rayAt(event->localPos());
    on_click(ray, depth);
  }
  dragging_ = false;
}

void
CloudView::mouseDoubleClickEvent(QMouseEvent*)
{
  if (const auto selected = model_.selected()) {
    camera_->setFocus(model_.scene().cloud.points[*selected]);
    moved();
  }
}

void
CloudView::wheelEvent(QWheelEvent* event)
{
  camera_->approach(std::pow(1.15, event->angleDelta().y() / 120.0));
  moved();
}

} // namespace linelet::view
