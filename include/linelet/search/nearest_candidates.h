// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <linelet/support/points.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Keeps the \a count nearest of \a candidates (squared distance and index);
 * ties go to the lower index.
 * \param[in,out] candidates left in any order
 * \param[out] found the indices kept, ascending
 * \return distance of the farthest of them; 0 if there are none */
double
keepNearest(std::vector<std::pair<double, Index>>& candidates,
            std::size_t count,
            Indices& found);

} // namespace linelet
