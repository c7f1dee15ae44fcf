// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <linelet/io/cloud.h>

#include "io/values.h"

namespace linelet::io {

constexpr std::size_t las_descriptor_size = 192;

/** \brief One entry of the extra bytes record, or undescribed bytes. */
struct LasExtra {
  std::string descriptor; ///< 192 bytes
  ValueType type = ValueType::UInt8;
  std::size_t bytes = 0;            ///< in each point record
  std::vector<std::string> columns; ///< one per component; none: opaque bytes
  std::array<bool, 3> scaled{};     ///< whether the column holds scale * raw + offset
  std::array<double, 3> scale{1, 1, 1};
  std::array<double, 3> offset{};
  std::string raw; ///< what the columns cannot represent, `bytes` per point, or empty
};

/** \brief Entries for \a bytes extra bytes according to the descriptors in \a text;
 * bytes they do not describe become opaque. \a complete: whether all descriptors were
 * used. */
std::vector<LasExtra>
parseLasExtras(std::string_view text, std::size_t bytes, bool& complete);

/** \brief The entry that describes \a column. */
LasExtra
describeLasExtra(const Column& column);

/** \brief An undocumented entry of \a bytes bytes (at most 255). */
LasExtra
opaqueLasExtra(std::size_t bytes);

} // namespace linelet::io
