// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "model/model.h"
#include "plot.h"

namespace linelet::view {

/** \brief Graphs of linearity, planarity and sphericity over radius at the
 * selection. */
class GraphsPanel : public Plot {
public:
  explicit GraphsPanel(const Model& model);
  void
  refresh();

private:
  const Model& model_;
};

} // namespace linelet::view
