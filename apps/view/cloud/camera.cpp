// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "camera.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <vtkCamera.h>

namespace linelet::view {

namespace {

constexpr double reach = 6;            ///< pixels around a click
constexpr double degrees = 180 / M_PI; ///< of a radian

Point
pointOf(const double* xyz)
{
  return {xyz[0], xyz[1], xyz[2]};
}

} // namespace

Camera::Camera(vtkRenderer& renderer, const QWidget& widget)
    : renderer_(renderer), widget_(widget)
{
}

void
Camera::look(double azimuth, double elevation)
{
  vtkCamera* camera = renderer_.GetActiveCamera();
  const double a = azimuth / degrees, e = std::clamp(elevation, -89.9, 89.9) / degrees;
  const Point back(-std::sin(a) * std::cos(e), -std::cos(a) * std::cos(e), std::sin(e));
  const Point eye = pointOf(camera->GetFocalPoint()) + camera->GetDistance() * back;
  camera->SetPosition(eye.x(), eye.y(), eye.z());
  camera->SetViewUp(0, 0, 1);
}

void
Camera::lookAt(const Point& place, double radius)
{
  vtkCamera* camera = renderer_.GetActiveCamera();
  const Point direction = pointOf(camera->GetDirectionOfProjection());
  const double half_angle = camera->GetViewAngle() / 2 / degrees;
  const Point eye = place - std::max(radius, 1e-6) / std::sin(half_angle) * direction;
  camera->SetFocalPoint(place.x(), place.y(), place.z());
  camera->SetPosition(eye.x(), eye.y(), eye.z());
}

void
Camera::showAll(const Box& box)
{
  vtkCamera* camera = renderer_.GetActiveCamera();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(0, -1, 0);
  camera->SetViewUp(0, 0, 1);
  const Point size = box.high - box.low;
  lookAt((box.low + box.high) / 2, std::max(0.33 * size.norm(), 1e-3));
  look(size.x() >= size.y() ? 20 : 290, 30); // the long side lies across
}

void
Camera::turn(QPoint step)
{
  vtkCamera* camera = renderer_.GetActiveCamera();
  const Point direction = pointOf(camera->GetDirectionOfProjection());
  const double azimuth = std::atan2(direction.x(), direction.y()) * degrees;
  const double elevation = -std::asin(std::clamp(direction.z(), -1.0, 1.0)) * degrees;
  look(azimuth + 0.35 * step.x(), elevation + 0.35 * step.y());
}

void
Camera::shift(QPoint step)
{
  vtkCamera* camera = renderer_.GetActiveCamera();
  const double world = 2 * camera->GetDistance() *
                       std::tan(camera->GetViewAngle() / 2 / degrees) /
                       std::max(widget_.height(), 1);
  const Point up = pointOf(camera->GetViewUp()),
              direction = pointOf(camera->GetDirectionOfProjection());
  const Point right = direction.cross(up).normalized(),
              above = right.cross(direction).normalized();
  const Point move = world * (-step.x() * right + step.y() * above);
  const Point eye = pointOf(camera->GetPosition()) + move,
              focus = pointOf(camera->GetFocalPoint()) + move;
  camera->SetPosition(eye.x(), eye.y(), eye.z());
  camera->SetFocalPoint(focus.x(), focus.y(), focus.z());
}

void
Camera::approach(double factor)
{
  renderer_.GetActiveCamera()->Dolly(factor);
}

void
Camera::setFocus(const Point& place)
{
  renderer_.GetActiveCamera()->SetFocalPoint(place.x(), place.y(), place.z());
}

QPointF
Camera::pixelOf(const Point& p) const
{
  renderer_.SetWorldPoint(p.x(), p.y(), p.z(), 1);
  renderer_.WorldToDisplay();
  const double* at = renderer_.GetDisplayPoint();
  const double ratio = widget_.devicePixelRatioF();
  return {at[0] / ratio, widget_.height() - 1 - at[1] / ratio};
}

std::pair<Ray, double>
Camera::rayAt(QPointF pixel, const Box& box) const
{
  const double ratio = widget_.devicePixelRatioF();
  vtkCamera* camera = renderer_.GetActiveCamera();
  const auto worldAt = [&](double depth) {
    renderer_.SetDisplayPoint(
        pixel.x() * ratio, (widget_.height() - 1 - pixel.y()) * ratio, depth);
    renderer_.DisplayToWorld();
    const double* at = renderer_.GetWorldPoint();
    return Point(at[0] / at[3], at[1] / at[3], at[2] / at[3]);
  };
  Ray ray;
  ray.origin = pointOf(camera->GetPosition());
  ray.direction = (worldAt(0.5) - ray.origin).normalized();
  ray.spread =
      reach * 2 * std::tan(camera->GetViewAngle() / 2 / degrees) / widget_.height();
  const double depth = (ray.origin - (box.low + box.high) / 2).norm() +
                       (box.high - box.low).norm() + 1e-3;
  return {ray, depth};
}

} // namespace linelet::view
