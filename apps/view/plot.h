// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <vector>

#include <QColor>
#include <QPointF>
#include <QString>
#include <QWidget>

namespace linelet::view {

/** \brief A chart: lines, bands, bars, marks, and handles to drag. */
class Plot : public QWidget {
public:
  struct Line {
    QString name; ///< for the legend; empty: not in it
    QColor color;
    double width = 1.5;
    std::vector<QPointF> points; ///< a y that is not finite breaks the line
    bool dots = false;           ///< dots instead of a line
    Qt::PenStyle style = Qt::SolidLine;
  };
  struct Band {
    QColor color;
    std::vector<QPointF> low, high;
  };
  struct Bar {
    double from, to, height;
  };
  struct Mark { ///< a vertical line
    double x;
    QColor color;
    QString text;
    double width = 1;
    double height = 1; ///< of the range of y
  };
  struct Handle {
    QPointF at;
    QString text;
    std::function<void(QPointF)> drag; ///< called with the position of the mouse
  };

  explicit Plot(QWidget* parent = nullptr);

  QString title, x_title, y_title, empty_text;
  bool log_x = false;
  bool equal_scales = false; ///< both axes have the same scale
  std::vector<Line> lines;
  std::vector<Band> bands;
  std::vector<Bar> bars;
  std::vector<Mark> marks;
  std::vector<Handle> handles;

  /** \brief Clears it, except for the titles. */
  void
  clear();

  /** \brief The range of x and y; otherwise that of all that is drawn. */
  void
  setRange(double x0, double x1, double y0, double y1);
  void
  fitRange();

  /** \brief Converts a value to pixels, and back. */
  QPointF
  toPixel(QPointF value) const;
  QPointF
  toValue(QPointF pixel) const;

protected:
  void
  paintEvent(QPaintEvent* event) override;
  void
  mousePressEvent(QMouseEvent* event) override;
  void
  mouseMoveEvent(QMouseEvent* event) override;
  void
  mouseReleaseEvent(QMouseEvent* event) override;

private:
  QRectF
  area() const;
  void
  drawAxes(QPainter& painter) const;
  void
  drawLegend(QPainter& painter) const;

  double x0_ = 0, x1_ = 1, y0_ = 0, y1_ = 1;
  int dragged_ = -1;
};

} // namespace linelet::view
