// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <vector>

#include <linelet/support/points.h>

namespace linelet::grid {

/** \brief Sorts \a keys, carrying \a values along; equal keys keep their order. Radix
 * sort, least significant digit first: linear in time, the same for any number of
 * threads.
 * \param[in] bits number of low bits in which the keys differ */
void
sortByKey(std::vector<std::uint64_t>& keys, Indices& values, int bits, int threads);

} // namespace linelet::grid
