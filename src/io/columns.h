// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <linelet/support/visibility.h>

#include "source.h"
#include "values.h"

namespace linelet::io {

/** \brief The names that Cloud uses for what other software calls \a names:
 * ReturnNumber, returnnumber, scalar_Return_Number, ... become return_number, unless
 * that is already among them; others are unchanged. */
std::vector<std::string>
canonicalNames(const std::vector<std::string>& names);

/** \brief \a name without white space and separators, for headers that consist of
 * words. */
std::string
wordName(std::string_view name);

/** \brief Makes a cloud from columns that include x, y and z. Packed colors (rgb, rgba)
 * are split.
 *
 * The shift is a whole number near the points if these are far from the origin, so that
 * subtracting it is exact. */
LINELET_PUBLIC Cloud
cloudFromColumns(const Source& source, std::vector<Column> columns);

/** \brief red, green and blue with 8 bits each, if that suffices: bytes, or 16-bit
 * values with an empty lower half, which is how LAS stores 8-bit colors. */
std::optional<std::array<std::vector<std::uint8_t>, 3>>
byteColors(const Cloud& cloud);

/** \brief Prefix of all attribute names except coordinates, normals and colors in PLY
 * files written by CloudCompare. */
constexpr std::string_view scalar_prefix = "scalar_";

/** \brief Whether \a name is red, green or blue. */
bool
isColor(std::string_view name);

/** \brief Writes \a column's value at \a i as text. */
void
appendValue(std::string& text, const Column& column, std::size_t i);

} // namespace linelet::io
