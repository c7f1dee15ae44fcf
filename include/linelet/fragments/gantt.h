// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/fragments/schedule.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC fragments {

/** \brief A schedule to draw, with its name. */
struct NamedSchedule {
  std::string name;
  Schedule schedule;
};

/** \brief Gantt charts of \a schedules on one axis of time, as the text of an SVG
 * picture: a row per device, a bar per fragment, darker the longer it takes, and the
 * makespan. */
std::string
ganttChart(const std::vector<NamedSchedule>& schedules,
           const std::vector<std::string>& devices);

} // namespace fragments
} // namespace linelet
