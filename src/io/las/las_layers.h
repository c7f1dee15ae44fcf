// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "io/laz/fields.h"
#include "las_format.h"

namespace linelet::io {

/** \brief The layers of a LAZ file that the attribute \a field of a point of formats 6
 * to 10 is in; none of those that are always decoded. */
laz::Fields
layersOf(const LasField& field);

} // namespace linelet::io
