// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <vector>

#include <linelet/powerline/power_line_network.h>

namespace linelet::powerline {

/** \brief The stretches of \a line that \a owns; its points are divided by length. */
std::vector<UnexplainedLine>
clipLine(const UnexplainedLine& line,
         const std::function<bool(double x, double y)>& owns);

/** \brief Joins lines that end within a few centimeters of where others begin; the
 * result is sorted, longest first, with ids. */
void
joinLines(std::vector<UnexplainedLine>& lines);

} // namespace linelet::powerline
