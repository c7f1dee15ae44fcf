// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

namespace linelet::apps {

/** \brief From now on a signal that asks the program to end (SIGINT, SIGTERM, SIGHUP,
 * SIGQUIT, SIGXCPU) makes \ref stopRequested true; work that does not hear of it within
 * a second and a half, or a second signal, ends the program without it. Either way no
 * unfinished file stays. A pipe without a reader and a file beyond the size limit are
 * errors of writing rather than signals.
 * \param[in] command name for the message. To be called once, before other threads. */
void
watchSignals(const std::string& command);

/** \brief Whether such a signal has come. */
bool
stopRequested();

} // namespace linelet::apps
