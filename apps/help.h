// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class Error;
} // namespace CLI

namespace linelet::apps {

/** \brief Heading of the options shared by all commands; they come last in the help. */
constexpr const char* common_options = "Every command";

/** \brief What `linelet COMMAND --help` prints: usage, what the command does, its
 * arguments, and its options by group, in lines of at most 80 characters. */
std::string
helpOf(const CLI::App& app);

/** \brief ", did you mean X?" for the word in \a known of which \a word is a likely
 * typo; empty if there is none. */
std::string
didYouMean(const std::string& word, const std::vector<std::string>& known);

/** \brief One line for a usage error: what is wrong, in which option file if it is in
 * one, and where to read more. */
std::string
usageError(const CLI::App* app, const CLI::Error& error);

} // namespace linelet::apps
