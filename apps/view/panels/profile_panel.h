// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "model/model.h"
#include "plot.h"

namespace linelet::view {

/** \brief The span of the current wire, seen from the side. */
class ProfilePanel : public Plot {
public:
  explicit ProfilePanel(const Model& model);
  void
  refresh();

private:
  const Model& model_;
};

} // namespace linelet::view
