// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>

#include "refine_component.h"

namespace linelet {

/** \brief \ref refineComponent of a share of \a points, so few that their spacing is
 * about \a size times as wide, for curves that are thick beside the spacing; the counts
 * are those of all points. */
EmFit
refineThinned(const Points& points,
              double size,
              const RefinedSettings& user,
              const std::function<bool()>& stop,
              const std::function<void(double)>& progress);

} // namespace linelet
