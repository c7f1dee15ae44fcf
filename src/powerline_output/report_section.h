// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "report_page.h"

namespace linelet::powerline::report {

/** \brief A section of the page. */
struct Section {
  std::string id;              ///< target of links; page/ID.mustache draws it
  std::string title;           ///< heading; may be empty
  nlohmann::ordered_json data; ///< for the template
};

} // namespace linelet::powerline::report
