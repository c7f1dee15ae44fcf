// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>

#include <QImage>
#include <QWidget>

#include "model/model.h"
#include "plot.h"

class QComboBox;
class QLabel;

namespace linelet::view {

/** \brief Graphs of linearity, planarity, sphericity over radius at the selection. */
class GraphsPanel : public Plot {
public:
  explicit GraphsPanel(const Model& model);
  void
  refresh();

private:
  const Model& model_;
};

/** \brief Weights w(r) over the distances of the neighbors at the selection, with
 * handles for the kernel's parameters and the radius. */
class KernelPanel : public QWidget {
public:
  explicit KernelPanel(Model& model);
  void
  refresh();

  /** \brief Called when a handle changed a setting. */
  std::function<void(Analysis)> on_change;

private:
  void
  setWeight(const std::string& text);

  Model& model_;
  Plot* plot_;
  QComboBox *of_, *kernel_;
};

/** \brief The multi-scale image: radii upwards, places to the right, colors of shape.
 */
class ImagePanel : public QWidget {
public:
  explicit ImagePanel(const Model& model);
  void
  refresh();

protected:
  void
  paintEvent(QPaintEvent* event) override;

private:
  const Model& model_;
  QImage image_;
};

/** \brief The span of the wire that is looked at, from the side. */
class ProfilePanel : public Plot {
public:
  explicit ProfilePanel(const Model& model);
  void
  refresh();

private:
  const Model& model_;
};

/** \brief Distance and angle along the chosen curve to the truth. */
class ErrorPanel : public Plot {
public:
  explicit ErrorPanel(const Model& model);
  void
  refresh();

private:
  const Model& model_;
};

/** \brief What the colors mean. */
class LegendPanel : public QWidget {
public:
  explicit LegendPanel(QWidget* parent = nullptr);
  void
  show(const Legend& legend);

protected:
  void
  paintEvent(QPaintEvent* event) override;

private:
  Legend legend_;
};

} // namespace linelet::view
