// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "io/laz/fields.h"
#include "las_format.h"

namespace linelet::io {

/** \brief The LAZ layers that hold the attribute \a field in point formats 6 to 10,
 * without those that are always decoded. */
laz::Fields
layersOf(const LasField& field);

} // namespace linelet::io
