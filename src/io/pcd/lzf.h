// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

namespace linelet::io {

/** \brief Unpacks LZF, the compression inside binary_compressed PCD files. False where
 * \a packed is not valid or does not unpack to the size that \a out has. */
bool
unpackLzf(std::string_view packed, std::string& out);

} // namespace linelet::io
