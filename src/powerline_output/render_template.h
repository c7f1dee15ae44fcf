// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace linelet::powerline::report {

/** \brief The Mustache template \a name of the folder page/, filled with \a data.
 *
 * Every file there can be included as a partial. A key that is null, false, an empty
 * string or list, or missing hides its section; {{key}} escapes for HTML, {{{key}}}
 * does not. Numbers appear as JSON writes them; pass formatted numbers as strings.
 * \throws std::logic_error for a template that is missing or does not parse */
std::string
renderTemplate(const std::string& name, const nlohmann::ordered_json& data);

} // namespace linelet::powerline::report
