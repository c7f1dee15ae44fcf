// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <QWidget>

#include "model/coloring.h"

namespace linelet::view {

/** \brief The legend of the colors. */
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
