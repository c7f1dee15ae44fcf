// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>

#include <linelet/io/cloud.h>

#include "dataset.h"

namespace linelet::io::hdf5 {

/** \brief Writes what \a origin keeps besides the points, except for bytes per point.
 */
void
writeLasOrigin(const Handle& group, const LasOrigin& origin);

/** \brief Reads it back, after checking all that the LAS writer relies on.
 * \param[in] cloud with its columns, to which the extra bytes must fit
 * \throws Error if it is damaged */
std::shared_ptr<LasOrigin>
readLasOrigin(const Handle& group, const Cloud& cloud);

/** \brief The dataset of what the columns of extra entry \a number cannot represent. */
std::string
rawName(std::size_t number);

} // namespace linelet::io::hdf5
