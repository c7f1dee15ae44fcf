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

/** \brief Which devices of a job compute, and which fragments each one gets. */
struct DeviceQueues {
  std::vector<std::size_t> devices; ///< of \ref FragmentJob::devices, by queue
  fragments::Dispatcher dispatcher; ///< places in the list of tasks
};

/** \brief Distributes \a tasks over the devices of \a job. A single device takes them
 * in order. With several, each first computes two parts of one fragment, which give its
 * time as a function of the number of points; devices that fail are left out, with a
 * warning.
 * \param[in] scratch file for results of these parts, removed at the end
 * \throws Canceled */
DeviceQueues
shareOut(FragmentJob& job,
         const fragments::Plan& plan,
         const fragments::Pieces& pieces,
         const std::vector<std::size_t>& tasks,
         const std::string& scratch,
         ProgressMonitor* monitor);

} // namespace linelet::apps
