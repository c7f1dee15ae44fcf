// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "io/source.h"

namespace linelet::io {

/** \brief The first \a size bytes of the gzip data \a packed, or fewer if it holds
 * fewer. Fails if \a packed is too short to hold that many, if it is damaged, and in a
 * build without zlib. */
std::string
gunzip(const Source& source, std::string_view packed, std::size_t size);

} // namespace linelet::io
