// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "run_job.h"

#include <numeric>
#include <stdexcept>

#include "fragment_run.h"
#include "plan_job.h"

namespace linelet::apps {

int
runJob(FragmentJob& job,
       const std::string& name,
       const std::vector<std::string>& arguments)
{
  if (!wantsFragments(job))
    return job.runWhole();
  job.check();
  using Existing = FragmentRun::Existing;
  FragmentRun run = FragmentRun::make(
      job, name, arguments, job.options().resume ? Existing::Resume : Existing::Remove);
  std::vector<std::size_t> tasks(run.plan().tiling.boxes());
  std::iota(tasks.begin(), tasks.end(), std::size_t{0});
  const auto failed = run.work(job, tasks, true);
  if (!failed.empty()) {
    const auto entry = run.ledger().find(fragments::Ledger::task, failed.front());
    throw std::runtime_error(
        (entry ? entry->reason : std::string("a fragment failed")) + " (" +
        std::to_string(failed.size()) + " of " + std::to_string(tasks.size()) +
        " fragments failed; fix the cause and run again with --resume)");
  }
  run.merge(job, false);
  run.remove();
  return job.frame().finish();
}

} // namespace linelet::apps
