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

/** \brief Heading of the options that every command has; they come last in its help. */
constexpr const char* common_options = "Every command";

/** \brief What `linelet COMMAND --help` prints: usage, what the command does, its
 * arguments, and its options by groups, in lines of at most 80 characters. */
std::string
helpOf(const CLI::App& app);

/** \brief ", did you mean X?" for the word of \a known that \a word is a slip of the
 * keyboard from; empty where there is none. */
std::string
didYouMean(const std::string& word, const std::vector<std::string>& known);

/** \brief One line for a usage error: what is wrong, in which option file if it is in
 * one, and where to read on. */
std::string
usageError(const CLI::App* app, const CLI::Error& error);

} // namespace linelet::apps
