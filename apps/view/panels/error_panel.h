// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "model/model.h"
#include "plot.h"

namespace linelet::view {

/** \brief Distance and angle along the chosen curve to the truth. */
class ErrorPanel : public Plot {
public:
  explicit ErrorPanel(const Model& model);
  void
  refresh();

private:
  const Model& model_;
};

} // namespace linelet::view
