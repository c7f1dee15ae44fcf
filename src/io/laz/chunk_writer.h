// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "layout.h"

namespace linelet::laz {

/** \brief The data of a chunk of \a count contiguous point records.
 * \param[in] layout of \ref layoutFor
 * \param[in,out] records used as scratch space, but unchanged afterward */
std::vector<std::uint8_t>
writeChunk(const Layout& layout, std::uint8_t* records, std::size_t count);

} // namespace linelet::laz
