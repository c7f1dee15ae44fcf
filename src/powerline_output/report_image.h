// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace linelet::powerline::report {

/** \brief \a data in base64. */
std::string
base64(const std::vector<std::uint8_t>& data);

/** \brief An 8-bit palette picture as PNG in base64, for a data URL.
 * \param[in] pixels row by row from the top, indices into \a palette */
std::string
pngBase64(std::size_t width,
          std::size_t height,
          const std::vector<std::uint8_t>& pixels,
          const std::vector<std::array<std::uint8_t, 3>>& palette);

} // namespace linelet::powerline::report
