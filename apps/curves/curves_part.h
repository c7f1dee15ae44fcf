// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/curves/curve_parts.h>

namespace linelet::apps {

/** \brief Writes the result of a fragment. \throws io::FileError */
void
saveCurvePart(const std::string& result, CurvePart part);

/** \brief Reads it. \throws io::FileError where it is missing or damaged */
CurvePart
loadCurvePart(const std::string& result);

} // namespace linelet::apps
