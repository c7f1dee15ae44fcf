// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "plot.h"

#include <algorithm>
#include <cmath>

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

namespace linelet::view {

namespace {

constexpr double handle_size = 6; // pixels
const QColor ink(40, 44, 50), grid_ink(225, 228, 232), paper(255, 255, 255);

/** \brief 1, 2 or 5 times a power of ten that divides \a range into about \a count. */
double
roundStep(double range, int count)
{
  const double raw = range / count, power = std::pow(10, std::floor(std::log10(raw)));
  const double lead = raw / power;
  return power * (lead <= 1.5 ? 1 : lead <= 3.5 ? 2 : lead <= 7.5 ? 5 : 10);
}

std::vector<double>
ticks(double low, double high, int count)
{
  std::vector<double> places;
  const double step = roundStep(high - low, std::max(count, 1));
  if (!(step > 0) || !std::isfinite(step))
    return places;
  for (double at = std::ceil(low / step) * step; at <= high + 1e-9 * step; at += step)
    places.push_back(std::abs(at) < 1e-9 * step ? 0 : at);
  return places;
}

std::vector<double>
logTicks(double low, double high)
{
  std::vector<double> places;
  for (double decade = std::pow(10, std::floor(std::log10(low))); decade <= high;
       decade *= 10)
    for (const double lead : {1.0, 2.0, 5.0})
      if (lead * decade >= low * (1 - 1e-9) && lead * decade <= high * (1 + 1e-9))
        places.push_back(lead * decade);
  return places;
}

} // namespace

Plot::Plot(QWidget* parent) : QWidget(parent)
{
  setMinimumSize(220, 150);
  setMouseTracking(true);
}

void
Plot::clear()
{
  lines.clear();
  bands.clear();
  bars.clear();
  marks.clear();
  handles.clear();
}

void
Plot::setRange(double x0, double x1, double y0, double y1)
{
  x0_ = x0;
  x1_ = x1 > x0 ? x1 : x0 + 1;
  y0_ = y0;
  y1_ = y1 > y0 ? y1 : y0 + 1;
}

void
Plot::fitRange()
{
  double x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY;
  const auto add = [&](const QPointF& p) {
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()))
      return;
    x0 = std::min(x0, p.x());
    x1 = std::max(x1, p.x());
    y0 = std::min(y0, p.y());
    y1 = std::max(y1, p.y());
  };
  for (const Line& line : lines)
    std::for_each(line.points.begin(), line.points.end(), add);
  for (const Bar& bar : bars) {
    add({bar.from, 0});
    add({bar.to, bar.height});
  }
  if (!(x0 <= x1))
    return setRange(0, 1, 0, 1);
  const double margin = 0.04 * (y1 - y0);
  setRange(x0, x1, y0 - margin, y1 + margin);
}

QRectF
Plot::area() const
{
  QRectF all(52,
             title.isEmpty() ? 10 : 26,
             width() - 64,
             height() - (title.isEmpty() ? 48 : 64));
  if (!equal_scales || all.width() <= 0 || all.height() <= 0)
    return all;
  const double scale = std::min(all.width() / (x1_ - x0_), all.height() / (y1_ - y0_));
  const double w = scale * (x1_ - x0_), h = scale * (y1_ - y0_);
  return {all.left() + (all.width() - w) / 2, all.top() + (all.height() - h) / 2, w, h};
}

QPointF
Plot::toPixel(QPointF value) const
{
  const QRectF in = area();
  const double x = log_x ? std::log(value.x() / x0_) / std::log(x1_ / x0_)
                         : (value.x() - x0_) / (x1_ - x0_);
  return {in.left() + x * in.width(),
          in.bottom() - (value.y() - y0_) / (y1_ - y0_) * in.height()};
}

QPointF
Plot::toValue(QPointF pixel) const
{
  const QRectF in = area();
  const double x = (pixel.x() - in.left()) / in.width();
  return {log_x ? x0_ * std::pow(x1_ / x0_, x) : x0_ + x * (x1_ - x0_),
          y0_ + (in.bottom() - pixel.y()) / in.height() * (y1_ - y0_)};
}

void
Plot::drawAxes(QPainter& painter) const
{
  const QRectF in = area();
  painter.setPen(ink);
  if (!title.isEmpty())
    painter.drawText(QRectF(4, 2, width() - 8, 22), Qt::AlignCenter, title);
  const int across = std::max(2, static_cast<int>(in.width() / 70)),
            up = std::max(2, static_cast<int>(in.height() / 36));
  for (const double x : log_x ? logTicks(x0_, x1_) : ticks(x0_, x1_, across)) {
    const double at = toPixel({x, y0_}).x();
    painter.setPen(grid_ink);
    painter.drawLine(QPointF(at, in.top()), QPointF(at, in.bottom()));
    painter.setPen(ink);
    painter.drawText(
        QRectF(at - 34, in.bottom() + 2, 68, 16), Qt::AlignCenter, QString::number(x));
  }
  for (const double y : ticks(y0_, y1_, up)) {
    const double at = toPixel({x0_, y}).y();
    painter.setPen(grid_ink);
    painter.drawLine(QPointF(in.left(), at), QPointF(in.right(), at));
    painter.setPen(ink);
    painter.drawText(QRectF(in.left() - 52, at - 8, 47, 16),
                     Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(y));
  }
  painter.setPen(ink);
  painter.drawRect(in);
  painter.drawText(
      QRectF(in.left(), in.bottom() + 17, in.width(), 18), Qt::AlignCenter, x_title);
  painter.save();
  painter.translate(11, in.center().y());
  painter.rotate(-90);
  painter.drawText(
      QRectF(-in.height() / 2, -10, in.height(), 18), Qt::AlignCenter, y_title);
  painter.restore();
}

void
Plot::drawLegend(QPainter& painter) const
{
  const QRectF in = area();
  double y = in.top() + 6;
  for (const Line& line : lines) {
    if (line.name.isEmpty())
      continue;
    const double length = painter.fontMetrics().horizontalAdvance(line.name);
    const QRectF box(in.right() - length - 34, y, length + 30, 16);
    painter.fillRect(box, QColor(255, 255, 255, 210));
    painter.setPen(QPen(line.color, line.dots ? 4 : 2, line.style));
    painter.drawLine(QPointF(box.left() + 3, y + 8), QPointF(box.left() + 19, y + 8));
    painter.setPen(ink);
    painter.drawText(box.adjusted(24, 0, 0, 0), Qt::AlignVCenter, line.name);
    y += 16;
  }
}

void
Plot::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.fillRect(rect(), paper);
  if (lines.empty() && bars.empty()) {
    painter.setPen(QColor(110, 116, 124));
    painter.drawText(rect().adjusted(12, 12, -12, -12),
                     Qt::AlignCenter | Qt::TextWordWrap,
                     empty_text);
    return;
  }
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF in = area();
  if (in.width() < 20 || in.height() < 20)
    return;
  drawAxes(painter);
  painter.setClipRect(in);
  painter.setPen(Qt::NoPen);
  for (const Bar& bar : bars) {
    const QPointF a = toPixel({bar.from, bar.height}), b = toPixel({bar.to, 0});
    painter.fillRect(QRectF(a, b).adjusted(0.5, 0, -0.5, 0), QColor(205, 210, 217));
  }
  for (const Band& band : bands) {
    QPolygonF outline;
    for (const QPointF& p : band.low)
      if (std::isfinite(p.y()))
        outline << toPixel(p);
    for (auto p = band.high.rbegin(); p != band.high.rend(); ++p)
      if (std::isfinite(p->y()))
        outline << toPixel(*p);
    painter.setBrush(band.color);
    painter.drawPolygon(outline);
  }
  painter.setBrush(Qt::NoBrush);
  for (const Mark& mark : marks) {
    const double x = toPixel({mark.x, 0}).x();
    painter.setPen(QPen(mark.color, mark.width));
    painter.drawLine(QPointF(x, in.bottom()),
                     QPointF(x, in.bottom() - mark.height * in.height()));
    painter.drawText(QPointF(x + 3, in.bottom() - mark.height * in.height() + 12),
                     mark.text);
  }
  for (const Line& line : lines) {
    painter.setPen(
        QPen(line.color, line.width, line.style, Qt::RoundCap, Qt::RoundJoin));
    if (line.dots) {
      QPolygonF dots;
      for (const QPointF& p : line.points)
        if (std::isfinite(p.x()) && std::isfinite(p.y()))
          dots << toPixel(p);
      painter.drawPoints(dots);
      continue;
    }
    QPainterPath path;
    bool begun = false;
    for (const QPointF& p : line.points) {
      const bool known = std::isfinite(p.x()) && std::isfinite(p.y());
      if (known && begun)
        path.lineTo(toPixel(p));
      else if (known)
        path.moveTo(toPixel(p));
      begun = known;
    }
    painter.drawPath(path);
  }
  painter.setClipping(false);
  for (const Handle& handle : handles) {
    const QPointF at = toPixel(handle.at);
    painter.setPen(QPen(ink, 1));
    painter.setBrush(QColor(255, 190, 40));
    painter.drawEllipse(at, handle_size, handle_size);
    painter.drawText(at + QPointF(9, -7), handle.text);
  }
  drawLegend(painter);
}

void
Plot::mousePressEvent(QMouseEvent* event)
{
  dragged_ = -1;
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const QPointF off = toPixel(handles[i].at) - event->localPos();
    if (std::hypot(off.x(), off.y()) < 2 * handle_size)
      dragged_ = static_cast<int>(i);
  }
}

void
Plot::mouseMoveEvent(QMouseEvent* event)
{
  if (dragged_ < 0 || static_cast<std::size_t>(dragged_) >= handles.size())
    return;
  // A copy: the callback may rebuild the handles.
  const auto drag = handles[static_cast<std::size_t>(dragged_)].drag;
  drag(toValue(event->localPos()));
}

void
Plot::mouseReleaseEvent(QMouseEvent*)
{
  dragged_ = -1;
}

} // namespace linelet::view
