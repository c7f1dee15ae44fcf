// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <utility>
#include <vector>

#include <linelet/io/cloud.h>

#include "color.h"

namespace linelet::apps {

/** \brief Colors of points by an attribute whose values are labels, not quantities. */
struct Categories {
  std::vector<Color> colors;                         ///< one per point
  std::vector<std::pair<Color, std::string>> legend; ///< the most frequent first
};

/** \brief Whether \a column holds labels rather than measures: classes, ids, return
 * numbers, flags. */
bool
isCategorical(const io::Column& column);

/** \brief Colors that are the same for every cloud: those of the ASPRS classes for
 * `classification`, otherwise well-separated hues by value, with 0 gray. */
Categories
categoriesOf(const io::Column& column);

} // namespace linelet::apps
