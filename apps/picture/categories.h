// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <utility>
#include <vector>

#include <linelet/io/cloud.h>

#include "color.h"

namespace linelet::apps {

/** \brief Colors of points by an attribute whose values are names, not quantities. */
struct Categories {
  std::vector<Color> colors;                         ///< one per point
  std::vector<std::pair<Color, std::string>> legend; ///< the most frequent first
};

/** \brief Whether \a column names rather than measures: classes, ids, numbers of
 * returns, flags. */
bool
isCategorical(const io::Column& column);

/** \brief Colors that stay the same from cloud to cloud: those of the ASPRS classes for
 * `classification`, else hues far from each other by value, 0 gray. */
Categories
categoriesOf(const io::Column& column);

} // namespace linelet::apps
