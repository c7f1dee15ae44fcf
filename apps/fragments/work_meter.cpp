// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "work_meter.h"

#include <sys/resource.h>

namespace linelet::apps {

double
WorkMeter::seconds() const
{
  return std::chrono::duration<double>(Clock::now() - begin_).count();
}

void
WorkMeter::note(fragments::Ledger::Entry& entry) const
{
  struct rusage usage {};
  ::getrusage(RUSAGE_SELF, &usage);
  entry.peak_bytes = 1024.0 * static_cast<double>(usage.ru_maxrss);
  entry.seconds = seconds();
}

} // namespace linelet::apps
