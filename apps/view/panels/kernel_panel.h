// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <string>

#include <QWidget>

#include "model/model.h"
#include "plot.h"

class QComboBox;

namespace linelet::view {

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

} // namespace linelet::view
