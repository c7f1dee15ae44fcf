// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace linelet::apps {

/** \brief The manual page of a command, in troff with the man(7) macros. */
std::string
manualOf(const CLI::App& app);

/** \brief The manual page of the tool as a whole. */
std::string
manualOfTool();

/** \brief What bash needs to know about a command: its options, and the words that each
 * takes, as entries of _linelet_options and _linelet_values. */
std::string
completionOf(const CLI::App& app);

/** \brief The script for bash-completion, without the entries of \ref completionOf. */
std::string
completionOfTool();

/** \brief Names of all commands, those of `generate` as two words. */
std::vector<std::string>
commandNames();

} // namespace linelet::apps
