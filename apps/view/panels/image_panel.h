// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QImage>
#include <QWidget>

#include "model/model.h"

namespace linelet::view {

/** \brief The multi-scale image: radii upward, positions to the right, colors by
 * shape. */
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

} // namespace linelet::view
