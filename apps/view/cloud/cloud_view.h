// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <memory>

#include <QPoint>
#include <QVTKOpenGLNativeWidget.h>

#include "model/model.h"
#include "model/picking.h"

class QTimer;

namespace linelet::view {

class Camera;

/** \brief The cloud in space, overlaid with curves, wires, selection and preview box.
 * Draws a random subset of the points while it moves, all when it is still. Left
 * button: rotate, click: pick; right or middle: pan; wheel: zoom. */
class CloudView : public QVTKOpenGLNativeWidget {
public:
  explicit CloudView(const Model& model, QWidget* parent = nullptr);
  ~CloudView() override;

  /** \brief Handles a click; the ray is in the coordinates of the cloud. */
  std::function<void(const Ray&, double depth)> on_click;

  /** \brief Shows another scene of the model. Resets the camera. */
  void
  showScene();

  void
  setColoring(const Coloring& coloring);
  void
  setPointSize(double pixels);
  void
  showLines(); ///< curves, truth, wires
  void
  showSelection(); ///< point, its ellipsoid, preview box, drawn line

  /** \brief Ellipsoids of the computed tensors, of a few thousand points. */
  void
  showEllipsoids(bool everywhere);

  Points drawn_line; ///< the line being drawn by the user

  /** \brief Rotates the camera: degrees clockwise from north, and above the horizon. */
  void
  look(double azimuth, double elevation);
  void
  lookAt(const Point& place, double radius);
  void
  showAll();

  /** \brief The pixel of a point of the cloud, from the upper left. */
  QPointF
  pixelOf(const Point& p) const;

  /** \brief The ray of a pixel, and how far the cloud extends along it. */
  std::pair<Ray, double>
  rayAt(QPointF pixel) const;

  /** \brief Draws all points now; for pictures. */
  void
  renderStill();

protected:
  void
  mousePressEvent(QMouseEvent* event) override;
  void
  mouseMoveEvent(QMouseEvent* event) override;
  void
  mouseReleaseEvent(QMouseEvent* event) override;
  void
  mouseDoubleClickEvent(QMouseEvent* event) override;
  void
  wheelEvent(QWheelEvent* event) override;

private:
  void
  moved();
  void
  setMoving(bool moving);

  struct Actors;
  const Model& model_;
  std::unique_ptr<Actors> actors_;
  std::unique_ptr<Camera> camera_; // of the actors' renderer
  QTimer* still_;
  QPoint pressed_, last_;
  bool dragging_ = false;
};

} // namespace linelet::view
