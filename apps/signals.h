// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace linelet::apps {

/** \brief From now on a signal that asks the program to end (SIGINT, SIGTERM, SIGHUP,
 * SIGQUIT, SIGXCPU) sets \ref stopRequested; if work does not end within a second and a
 * half, or on a second signal, the program is terminated. Either way no unfinished file
 * remains. A pipe without a reader and a file beyond the size limit are write errors,
 * not signals.
 * \param[in] command name for the message. Call once, before other threads start. */
void
watchSignals(const std::string& command);

/** \brief Whether such a signal has arrived. */
bool
stopRequested();

} // namespace linelet::apps
