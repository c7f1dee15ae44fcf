// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/data_border.h"

#include "powerline/pieces/span_model.h"
#include "powerline/terrain/underside.h"

namespace linelet::powerline {

namespace {

constexpr double border_step = 5;  // meters beyond an end
constexpr double border_reach = 2; // meters around that place

} // namespace

bool
leavesData(const SpanModel& model, int side, const Underside& underside)
{
  const Point p =
      model.at(side == 0 ? model.begin - border_step : model.end + border_step);
  return underside.emptyAround(p.x(), p.y(), border_reach);
}

} // namespace linelet::powerline
