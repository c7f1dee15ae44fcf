// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "legend_panel.h"

#include <algorithm>

#include <QPainter>

#include "panel_colors.h"

namespace linelet::view {

LegendPanel::LegendPanel(QWidget* parent) : QWidget(parent)
{
  setMinimumHeight(90);
}

void
LegendPanel::show(const Legend& legend)
{
  legend_ = legend;
  const int rows = static_cast<int>(legend.entries.size());
  setMinimumHeight(legend.shape ? 146 : rows > 0 ? 26 + 17 * rows : 66);
  update();
}

void
LegendPanel::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(dark);
  painter.drawText(QRectF(4, 2, width() - 8, 18),
                   Qt::AlignLeft | Qt::AlignVCenter,
                   QString::fromStdString(legend_.title));
  if (legend_.scale) {
    const QRectF bar(6, 22, width() - 12, 16);
    for (int i = 0; i < static_cast<int>(bar.width()); ++i)
      painter.fillRect(QRectF(bar.left() + i, bar.top(), 1.5, bar.height()),
                       colorOf(apps::scalarColor(i / bar.width())));
    for (const double part : {0.0, 0.5, 1.0})
      painter.drawText(
          QRectF(bar.left() + part * (bar.width() - 70), 40, 70, 18),
          part == 0   ? Qt::AlignLeft
          : part == 1 ? Qt::AlignRight
                      : Qt::AlignCenter,
          QString::number(legend_.low + part * (legend_.high - legend_.low), 'g', 5));
    return;
  }
  if (legend_.shape) {
    // Barycentric: linear to the left, planar to the right, spherical above.
    const double side = std::min(110.0, width() - 120.0), rise = 0.87 * side;
    const QPointF corner(10, 24);
    for (int y = 0; y < static_cast<int>(rise); ++y)
      for (int x = 0; x < static_cast<int>(side); ++x) {
        const double s = 1 - y / rise, p = x / side - s / 2, l = 1 - s - p;
        if (p >= 0 && l >= 0)
          painter.fillRect(QRectF(corner.x() + x, corner.y() + y, 1.2, 1.2),
                           colorOf(apps::shapeColor(apps::ShapeColors::Safe, l, p, s)));
      }
    painter.drawText(QPointF(corner.x() + side / 2 + 16, corner.y() + 12), "spherical");
    painter.drawText(QPointF(corner.x() + side + 4, corner.y() + rise), "planar");
    painter.drawText(QPointF(corner.x() - 4, corner.y() + rise + 15), "linear");
    return;
  }
  for (std::size_t i = 0; i < legend_.entries.size(); ++i) {
    const double y = 22 + 17 * static_cast<double>(i);
    painter.fillRect(QRectF(6, y + 3, 12, 12), colorOf(legend_.entries[i].color));
    painter.drawText(QRectF(24, y, width() - 28, 18),
                     Qt::AlignLeft | Qt::AlignVCenter,
                     QString::fromStdString(legend_.entries[i].text));
  }
}

} // namespace linelet::view
