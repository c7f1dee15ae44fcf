// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <future>
#include <utility>

#include <malloc.h>

#include <linelet/fragments/pieces.h>
#include <linelet/fragments/records.h>

#include "fragment_run.h"
#include "quiet_monitor.h"
#include "work_meter.h"

namespace linelet::apps {

using fragments::Ledger;

namespace {

/** \brief Keeps the memory of one fragment for the next: asking for it page by page
 * would take as long as computing. */
void
keepFreedMemory()
{
#ifdef M_MMAP_THRESHOLD
  ::mallopt(M_MMAP_THRESHOLD, 1 << 28);
  ::mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
}

/** \brief What comes next is of another shape. */
void
giveBackFreedMemory()
{
#ifdef M_TRIM_THRESHOLD
  ::malloc_trim(0);
#endif
}

} // namespace

void
FragmentRun::computeOne(FragmentJob& job, const fragments::Fragment& fragment)
{
  const WorkMeter meter;
  QuietMonitor monitor(job.frame().monitor);
  Ledger::Entry entry;
  entry.figures = job.compute(
      {plan_, fragment, fragments::resultPath(folder_, fragment.number), &monitor});
  entry.done = true;
  entry.points = static_cast<double>(fragment.owned());
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
  const auto load = [&](std::size_t task) { return pieces.load(task, &monitor); };
  std::vector<std::size_t> left, failed;
  for (const std::size_t task : tasks)
    if (!ledger_.done(Ledger::task, task))
      left.push_back(task);
  job.frame().monitor.begin("fragments", tasks.size());
  job.frame().monitor.advance(tasks.size() - left.size());
  bool told = false;
  std::future<fragments::Fragment> next;
  for (std::size_t i = 0; i < left.size(); ++i) {
    const std::size_t task = left[i];
    std::string reason;
    for (const bool again : {false, true}) {
      try {
        const fragments::Fragment fragment = next.valid() ? next.get() : load(task);
        if (!again && i + 1 < left.size())
          next = std::async(std::launch::async, load, left[i + 1]);
        if (static_cast<double>(fragment.points.size()) > 1.5 * plan_.most_points &&
            !std::exchange(told, true))
          job.frame().warn("fragment " + std::to_string(task) + " has " +
                           std::to_string(fragment.points.size()) +
                           " points, more than headers told; if memory runs out, plan "
                           "with a smaller --chunk");
        computeOne(job, fragment);
        reason.clear();
        break;
      }
      catch (const Canceled&) {
        throw;
      }
      catch (const std::exception& error) {
        throwIfCanceled(&monitor);
        reason = error.what();
        if (ledger_.done(Ledger::task, task)) { // by another worker
          reason.clear();
          break;
        }
        if (again || next.valid())
          continue;
      }
    }
    if (reason.empty())
      pieces.remove(task);
    else {
      failed.push_back(task);
      Ledger::Entry entry;
      entry.reason = reason;
      ledger_.write(Ledger::task, task, entry);
    }
    if (i + 1 == left.size())
      giveBackFreedMemory();
    if (outputs)
      writeReady(job);
    job.frame().monitor.advance(1);
  }
  return failed;
}

} // namespace linelet::apps
