// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <atomic>
#include <optional>

#include <malloc.h>

#include <linelet/fragments/executor.h>
#include <linelet/fragments/pieces.h>
#include <linelet/fragments/records.h>

#include "device_queues.h"
#include "fragment_run.h"
#include "output_queue.h"
#include "quiet_monitor.h"
#include "work_meter.h"

namespace linelet::apps {

using fragments::Ledger;

namespace {

/** \brief Keeps the memory of one fragment for the next: getting it page by page again
 * would take as long as the computation. */
void
keepFreedMemory()
{
#ifdef M_MMAP_THRESHOLD
  ::mallopt(M_MMAP_THRESHOLD, 1 << 28);
  ::mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
}

/** \brief Later allocations have different sizes. */
void
giveBackFreedMemory()
{
#ifdef M_MMAP_THRESHOLD
  ::mallopt(M_MMAP_THRESHOLD, 1 << 20);
  ::mallopt(M_TRIM_THRESHOLD, 1 << 20);
  ::malloc_trim(0);
#endif
}

} // namespace

void
FragmentRun::computeOne(FragmentJob& job,
                        fragments::Fragment& fragment,
                        std::size_t device,
                        const std::string& device_name)
{
  const WorkMeter meter;
  QuietMonitor monitor(job.frame().monitor);
  Ledger::Entry entry;
  entry.figures = job.compute({plan_,
                               fragment,
                               device,
                               fragments::resultPath(folder_, fragment.number),
                               &monitor});
  entry.done = true;
  entry.points = static_cast<double>(fragment.owned());
  entry.device = device_name;
  meter.note(entry);
  ledger_.write(Ledger::task, fragment.number, entry);
}

std::vector<std::size_t>
FragmentRun::work(FragmentJob& job, const std::vector<std::size_t>& tasks, bool outputs)
{
  keepFreedMemory();
  QuietMonitor monitor(job.frame().monitor);
  const fragments::Pieces pieces(
      plan_, folder_, job.input().readOptions(), job.input().classes());
  std::vector<std::size_t> left, failed;
  for (const std::size_t task : tasks)
    if (!ledger_.done(Ledger::task, task))
      left.push_back(task);
  job.frame().monitor.begin("fragments", tasks.size());
  job.frame().monitor.advance(tasks.size() - left.size());
  std::optional<OutputQueue> queue;
  if (outputs)
    queue.emplace(job, plan_, folder_, ledger_, [&](auto number, const auto& done) {
      writeOutput(job, number, done);
    });
  if (queue)
    queue->begin();
  const std::vector<std::string> names = job.devices().names;
  DeviceQueues shared =
      shareOut(job, plan_, pieces, left, folder_ + "/measured", &monitor);
  std::atomic<bool> told{false};
  std::size_t settled = 0;

  fragments::FragmentWork work;
  work.load = [&](std::size_t k) { return pieces.load(left[k], &monitor); };
  work.compute = [&](fragments::Fragment& fragment, auto, std::size_t d) {
    if (static_cast<double>(fragment.points.size()) > 1.5 * plan_.most_points &&
        !told.exchange(true))
      job.frame().warn("fragment " + std::to_string(fragment.number) + " has " +
                       std::to_string(fragment.points.size()) +
                       " points, more than --memory allows for; if memory runs out, "
                       "plan with a smaller --chunk");
    const std::size_t device = shared.devices[d];
    computeOne(job, fragment, device, names[device]);
  };
  work.settle = [&](std::size_t k, const std::string& reason) {
    const std::size_t task = left[k];
    const bool done =
        reason.empty() || ledger_.done(Ledger::task, task); // by another worker
    if (done)
      pieces.remove(task);
    else {
      failed.push_back(task);
      Ledger::Entry entry;
      entry.reason = reason;
      ledger_.write(Ledger::task, task, entry);
    }
    if (++settled == left.size())
      giveBackFreedMemory();
    if (done && queue)
      queue->add(task);
    job.frame().monitor.advance(1);
  };
  fragments::execute(shared.dispatcher, shared.devices.size(), work, &monitor);
  std::sort(failed.begin(), failed.end());
  return failed;
}

} // namespace linelet::apps
