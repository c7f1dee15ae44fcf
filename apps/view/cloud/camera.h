// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <utility>

#include <QPoint>
#include <QPointF>
#include <QWidget>
#include <vtkRenderer.h>

#include <linelet/support/points.h>

#include "model/picking.h"
#include "model/scene.h"

namespace linelet::view {

/** \brief The camera of a renderer, kept upright, in a widget whose pixels count from
 * the upper left. */
class Camera {
public:
  /** Both must outlive this. */
  Camera(vtkRenderer& renderer, const QWidget& widget);

  /** \brief Rotates it about its focal point: degrees clockwise from north, and above
   * the horizon. */
  void
  look(double azimuth, double elevation);
  void
  lookAt(const Point& place, double radius);
  void
  showAll(const Box& box);

  /** \brief Rotates it with the mouse. */
  void
  turn(QPoint step);
  /** \brief Pans it so that its focal point follows the mouse. */
  void
  shift(QPoint step);
  void
  approach(double factor);
  void
  setFocus(const Point& place);

  QPointF
  pixelOf(const Point& p) const;

  /** \brief The ray of a pixel, and how far \a box extends along it. */
  std::pair<Ray, double>
  rayAt(QPointF pixel, const Box& box) const;

private:
  vtkRenderer& renderer_;
  const QWidget& widget_;
};

} // namespace linelet::view
