// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <linelet/curves/curve_parts.h>

namespace linelet::apps {

/** \brief What a fragment found in one of its blocks. */
struct BlockPart {
  std::size_t block = 0;
  CurvePart curves;
};

/** \brief Writes the result of a fragment. \throws io::FileError */
void
saveBlockParts(const std::string& result, std::vector<BlockPart> parts);

/** \brief \throws io::FileError if it is missing or damaged */
std::vector<BlockPart>
loadBlockParts(const std::string& result);

} // namespace linelet::apps
