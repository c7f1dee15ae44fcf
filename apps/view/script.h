// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace linelet::view {

class Window;

/** \brief Runs the steps of the file \a path, one per line, with the functions that
 * buttons and clicks call, and waits after each for the work it started. Empty lines
 * and lines that begin with # are ignored.
 * \throws std::runtime_error with file and line, if a step is unknown or fails */
void
runScript(Window& window, const std::string& path);

/** \brief The list of steps, for --help. */
std::string
scriptHelp();

} // namespace linelet::view
