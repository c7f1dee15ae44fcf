// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "io/source.h"

namespace linelet::io {

/** \brief The first \a size bytes that \a packed holds by gzip, fewer if there are no
 * more. Fails if so few packed bytes cannot hold them all, if they are damaged, and in
 * a build without zlib. */
std::string
gunzip(const Source& source, std::string_view packed, std::size_t size);

} // namespace linelet::io
