// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <linelet/support/points.h>

namespace linelet {

/** \brief Sorts \a indices in ascending order; long lists by digits (radix sort),
 * several times as fast as by comparison. */
void
sortIndices(Indices& indices);

} // namespace linelet
