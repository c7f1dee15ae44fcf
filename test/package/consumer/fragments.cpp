// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/fragments/schedule.h>

int
main()
{
  linelet::fragments::ExpectedTimes times(2, 2);
  times(0, 0) = times(1, 1) = 1;
  times(0, 1) = times(1, 0) = 5;
  const auto schedule = linelet::fragments::minMin(times);
  return linelet::fragments::makespan(schedule) == 1 ? 0 : 1;
}
