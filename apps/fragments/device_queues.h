// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <linelet/fragments/dispatcher.h>
#include <linelet/fragments/pieces.h>

#include "fragment_job.h"

namespace linelet::apps {

/** \brief Which devices of a job compute, and which fragments each gets. */
struct DeviceQueues {
  std::vector<std::size_t> devices; ///< of \ref FragmentJob::devices, by queue
  fragments::Dispatcher dispatcher; ///< of places in the list of tasks
};

/** \brief Shares \a tasks out among the devices of \a job. One device takes them in
 * their order. Of several, each first computes a part of one fragment in two sizes,
 * which tells the time that it takes by number of points; devices that fail at that are
 * left out, with a warning.
 * \param[in] scratch file to write results of these parts to, removed at the end
 * \throws Canceled */
DeviceQueues
shareOut(FragmentJob& job,
         const fragments::Plan& plan,
         const fragments::Pieces& pieces,
         const std::vector<std::size_t>& tasks,
         const std::string& scratch,
         ProgressMonitor* monitor);

} // namespace linelet::apps
