// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include "fragment_job.h"

namespace linelet::apps {

/** \brief Runs \a job: in one piece if that fits its memory, otherwise in fragments, in
 * this process.
 * \param[in] arguments its command line
 * \return the exit code */
int
runJob(FragmentJob& job,
       const std::string& name,
       const std::vector<std::string>& arguments);

} // namespace linelet::apps
