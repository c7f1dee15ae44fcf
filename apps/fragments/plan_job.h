// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/fragments/plan.h>

#include "fragment_job.h"

namespace linelet::apps {

/** \brief Whether \a job runs in fragments: on request, or because the whole cloud
 * would exceed its memory. */
bool
wantsFragments(FragmentJob& job);

/** \brief The plan of \a job, from headers.
 * \param[in] arguments its command line */
fragments::Plan
planOf(FragmentJob& job,
       const std::string& name,
       const std::vector<std::string>& arguments);

} // namespace linelet::apps
