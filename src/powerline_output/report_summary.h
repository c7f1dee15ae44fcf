// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>

#include "report_section.h"

namespace linelet::powerline::report {

/** \brief "1 wire", "2 wires". */
inline std::string
counted(std::size_t count, const std::string& one)
{
  return std::to_string(count) + " " + (count == 1 ? one : one + "s");
}

/** \brief The most important figures: lines, lengths, how many wires are too low. */
Section
summarySection(const Content& content);

} // namespace linelet::powerline::report
