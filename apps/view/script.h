// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace linelet::view {

class Window;

/** \brief Runs the steps of the file \a path, one per line, with the functions that
 * buttons and clicks call, and after each of them waits for what it began. Empty lines
 * and lines that begin with # say nothing.
 * \throws std::runtime_error with file and line, where a step is not known or fails */
void
runScript(Window& window, const std::string& path);

/** \brief What steps there are, for --help. */
std::string
scriptHelp();

} // namespace linelet::view
