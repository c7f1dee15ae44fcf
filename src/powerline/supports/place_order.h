// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <vector>

#include "powerline/spans/wire_with_ends.h"
#include "powerline/supports/tower.h"

namespace linelet::powerline {

/** \brief Indices of \a wires from west to east by their ends: an order that depends
 * only on their positions. */
std::vector<std::size_t>
orderByPlace(const std::vector<WireWithEnds>& wires);

/** \brief Sorts wires into that order, and supports likewise by their axes. */
void
sortByPlace(std::vector<WireWithEnds>& wires, std::vector<Tower>& towers);

} // namespace linelet::powerline
