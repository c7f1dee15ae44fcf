// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "image_panel.h"

#include <algorithm>
#include <cmath>

#include <QPainter>

#include "panel_colors.h"

namespace linelet::view {

ImagePanel::ImagePanel(const Model& model) : model_(model)
{
  setMinimumSize(220, 150);
}

void
ImagePanel::refresh()
{
  const ScaleImage* image = model_.image();
  image_ = QImage();
  if (image != nullptr && !image->columns.empty()) {
    const int w = static_cast<int>(image->columns.size()),
              h = static_cast<int>(image->radii.size());
    image_ = QImage(w, h, QImage::Format_RGB32);
    for (int x = 0; x < w; ++x)
      for (int y = 0; y < h; ++y) {
        const ScaleShape& s = image->columns[static_cast<std::size_t>(x)]
                                            [static_cast<std::size_t>(h - 1 - y)];
        const QColor color =
            std::isnan(s.linearity)
                ? QColor(255, 255, 255)
                : colorOf(apps::shapeColor(apps::ShapeColors::Safe,
                                           static_cast<double>(s.linearity),
                                           static_cast<double>(s.planarity),
                                           static_cast<double>(s.sphericity)));
        image_.setPixelColor(x, y, color);
      }
  }
  update();
}

void
ImagePanel::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.fillRect(rect(), Qt::white);
  const ScaleImage* image = model_.image();
  if (image_.isNull() || image == nullptr) {
    painter.setPen(QColor(110, 116, 124));
    painter.drawText(
        rect().adjusted(12, 12, -12, -12),
        Qt::AlignCenter | Qt::TextWordWrap,
        "Shape over radius at every position: choose Image along the curve, "
        "along a line that you draw, or around the selected point.");
    return;
  }
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF in(56, 14, width() - 68, height() - 56);
  painter.drawImage(in, image_);
  const auto columns = static_cast<double>(image->columns.size());
  const auto rows = static_cast<double>(image->radii.size());
  const auto x = [&](std::size_t i) {
    return in.left() + (static_cast<double>(i) + 0.5) / columns * in.width();
  };
  // The optimal scale at every position, and the area under its linearity graph.
  float most = 1e-9F;
  for (const MultiScaleShape& shape : image->shapes)
    most = std::max(most, std::isnan(shape.linearity_sum) ? 0 : shape.linearity_sum);
  QPolygonF sum;
  for (std::size_t i = 0; i < image->shapes.size(); ++i) {
    const MultiScaleShape& shape = image->shapes[i];
    if (shape.scale >= 0) {
      const double y = in.bottom() - (shape.scale + 0.5) / rows * in.height();
      painter.fillRect(QRectF(x(i) - in.width() / columns / 2,
                              y - 1.5,
                              std::max(1.0, in.width() / columns),
                              3),
                       Qt::black);
    }
    if (!std::isnan(shape.linearity_sum))
      sum << QPointF(x(i),
                     in.bottom() -
                         static_cast<double>(shape.linearity_sum / most) * in.height());
  }
  painter.setPen(QPen(spherical_color, 1.5));
  painter.drawPolyline(sum);
  painter.setPen(dark);
  painter.drawRect(in);
  const int step =
      std::max(1, static_cast<int>(18 * rows / std::max(in.height(), 1.0)) + 1);
  for (std::size_t k = 0; k < image->radii.size(); k += static_cast<std::size_t>(step))
    painter.drawText(
        QRectF(0,
               in.bottom() - (static_cast<double>(k) + 0.5) / rows * in.height() - 8,
               52,
               16),
        Qt::AlignRight | Qt::AlignVCenter,
        QString::number(image->radii[k], 'g', 3));
  for (const double part : {0.0, 0.5, 1.0}) {
    const auto i = static_cast<std::size_t>(part * (columns - 1));
    painter.drawText(QRectF(x(i) - 50, in.bottom() + 2, 100, 16),
                     Qt::AlignCenter,
                     QString::number(image->along[i], 'g', 4));
  }
  painter.drawText(
      QRectF(in.left(), in.bottom() + 18, in.width(), 18),
      Qt::AlignCenter,
      "position along the line (black: optimal radius; green: area under the "
      "linearity graph); upward: radius");
}

} // namespace linelet::view
