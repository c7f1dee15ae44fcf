// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace linelet::apps {

/** \brief The manual page of a command, as troff with the macros of man(7). */
std::string
manualOf(const CLI::App& app);

/** \brief The manual page of the tool as a whole. */
std::string
manualOfTool();

/** \brief What bash needs to know of a command: its options, and the words that each
 * takes, as entries of _linelet_options and _linelet_values. */
std::string
completionOf(const CLI::App& app);

/** \brief The script for bash-completion, but for the entries of \ref completionOf. */
std::string
completionOfTool();

/** \brief Names of all commands, those of `generate` in two words. */
std::vector<std::string>
commandNames();

} // namespace linelet::apps
