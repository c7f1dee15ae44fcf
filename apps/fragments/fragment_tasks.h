// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <linelet/fragments/pieces.h>
#include <linelet/fragments/plan.h>
#include <linelet/support/progress_monitor.h>

namespace linelet::apps {

/** \brief Numbers by name. */
using Figures = std::map<std::string, double>;

/** \brief A fragment to compute. */
struct FragmentTask {
  const fragments::Plan& plan;
  fragments::Fragment& fragment; ///< its points may be moved from
  std::size_t device;            ///< place in FragmentJob::devices
  std::string result;            ///< file to write
  ProgressMonitor* monitor;
};

/** \brief An output to write from the results of fragments. */
struct OutputTask {
  const fragments::Plan& plan;
  const std::string& folder;       ///< of the run
  std::size_t number;              ///< of the output
  const std::vector<bool>& usable; ///< fragments with a result; all, or --partial
  ProgressMonitor* monitor;
};

} // namespace linelet::apps
