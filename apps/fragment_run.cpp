// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fragment_run.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <future>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include <malloc.h>
#include <sys/resource.h>

#include <linelet/fragments/records.h>
#include <linelet/io/cloud_stream.h>

#include "version.h"

namespace linelet::apps {

namespace fs = std::filesystem;
using fragments::Ledger;

namespace {

/** \brief Passes on that work is to end, and nothing else: progress is by fragment. */
class QuietMonitor : public ProgressMonitor {
public:
  explicit QuietMonitor(const ProgressMonitor& outer) : outer_(outer) {}
  void
  begin(std::string_view, std::size_t) override
  {
  }
  void
  advance(std::size_t) override
  {
  }
  bool
  canceled() const override
  {
    return outer_.canceled();
  }

private:
  const ProgressMonitor& outer_;
};

double
peakBytes()
{
  struct rusage usage {};
  ::getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

double
secondsSince(std::chrono::steady_clock::time_point begin)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
      .count();
}

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

bool
isLas(const std::string& path)
{
  return io::CloudSink::takes(path); // the same endings
}

bool
wantsFragments(FragmentJob& job)
{
  const FragmentOptions& options = job.options();
  if (options.chunk > 0 || options.resume)
    return true;
  double points = 0;
  for (const std::string& file : job.input().files())
    if (!isLas(file))
      return false; // only headers of these are quickly read
  try {
    for (const io::FileSummary& file : job.input().summaries())
      points += static_cast<double>(file.points);
  }
  catch (const io::FileError&) {
    return false; // told when the file is read, after the outputs have been looked at
  }
  return points * job.bytesPerPoint(false) > options.memory.bytes();
}

/** The extent of a file by its header. Those are written with fewer digits by some. */
fragments::PlannedInput
plannedInput(const io::FileSummary& file)
{
  fragments::PlannedInput input = fragments::stateOf(file.path);
  input.extent.points = static_cast<double>(file.points);
  const double size = (file.high - file.low).norm();
  for (int a = 0; a < 2; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    const double margin =
        1e-5 * size + 1e-9 * std::max(std::abs(file.low[a]), std::abs(file.high[a]));
    input.extent.area.low[axis] = file.low[a] - margin;
    input.extent.area.high[axis] = file.high[a] + margin;
  }
  input.low_z = file.low.z();
  input.high_z = file.high.z();
  return input;
}

fragments::Plan
planOf(FragmentJob& job,
       const std::string& name,
       const std::vector<std::string>& arguments)
{
  fragments::Plan plan;
  plan.version = LINELET_VERSION;
  plan.command = name;
  for (const std::string& argument : arguments)
    if (argument != "--resume")
      plan.arguments.push_back(argument);
  plan.place = fs::current_path().string();
  plan.ghost = job.ghost();
  // What the program, the tables and a block of the input take beside the points.
  constexpr double base = 250e6;
  const double memory = job.options().memory.bytes();
  plan.most_points = std::max(memory - base, memory / 8) / job.bytesPerPoint(true);
  std::vector<fragments::Extent> extents;
  for (const io::FileSummary& file : job.input().summaries()) {
    plan.inputs.push_back(plannedInput(file));
    if (file.points > 0)
      extents.push_back(plan.inputs.back().extent);
  }
  plan.shift = job.input().shift();
  plan.tiling =
      fragments::Tiling(extents, {plan.ghost, job.options().chunk, plan.most_points});
  return plan;
}

} // namespace

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
    const auto entry = run.ledger().find(Ledger::task, failed.front());
    throw std::runtime_error(
        (entry ? entry->reason : std::string("a fragment failed")) + " (" +
        std::to_string(failed.size()) + " of " + std::to_string(tasks.size()) +
        " fragments failed; mend it and run again with --resume)");
  }
  run.merge(job, false);
  run.remove();
  return job.frame().finish();
}

FragmentRun::FragmentRun(fragments::Plan plan, std::string folder)
    : plan_(std::move(plan)),
      folder_(std::move(folder)),
      ledger_(folder_, plan_.fingerprint())
{
}

std::string
FragmentRun::folderOf(const std::string& place)
{
  fs::path path = fs::absolute(place).lexically_normal();
  if (path.filename().empty())
    path = path.parent_path();
  return path.string() + ".fragments";
}

FragmentRun
FragmentRun::make(FragmentJob& job,
                  const std::string& name,
                  const std::vector<std::string>& arguments,
                  Existing existing)
{
  FragmentRun run(planOf(job, name, arguments), folderOf(job.place()));
  const bool same = [&] {
    try {
      return fragments::loadPlan(run.folder_).fingerprint() == run.plan_.fingerprint();
    }
    catch (const std::exception&) {
      return false;
    }
  }();
  if (existing == Existing::Resume && !same &&
      fs::exists(fs::path(run.folder_) / "plan.json"))
    throw io::FileError(run.folder_ +
                        ": is of other inputs, options or another version of linelet; "
                        "run without --resume to begin anew");
  if (existing == Existing::Remove || !same)
    run.remove();
  fragments::savePlan(run.plan_, run.folder_);
  run.ledger_.forgetFailures();
  return run;
}

FragmentRun
FragmentRun::open(const std::string& place, std::unique_ptr<FragmentJob>& job)
{
  FragmentRun run(fragments::loadPlan(folderOf(place)), folderOf(place));
  if (run.plan_.version != LINELET_VERSION)
    throw io::FileError(run.folder_ + ": was planned by linelet " + run.plan_.version +
                        ", this is " LINELET_VERSION "; plan again");
  fragments::checkInputs(run.plan_);
  std::error_code error;
  fs::current_path(run.plan_.place, error);
  if (error)
    throw io::FileError(run.plan_.place + ": cannot be entered, where it was planned; "
                                          "mount it under the same name here");
  job = makeFragmentJob(run.plan_.command, run.plan_.arguments);
  job->check();
  return run;
}

void
FragmentRun::remove() const
{
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void
FragmentRun::computeOne(FragmentJob& job,
                        const fragments::Fragment& fragment,
                        double& seconds)
{
  const auto begin = std::chrono::steady_clock::now();
  QuietMonitor monitor(job.frame().monitor);
  Ledger::Entry entry;
  entry.figures = job.compute(
      plan_, fragment, fragments::resultPath(folder_, fragment.number), &monitor);
  entry.done = true;
  entry.points = static_cast<double>(fragment.owned());
  entry.seconds = seconds = secondsSince(begin);
  entry.peak_bytes = peakBytes();
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
        double seconds = 0;
        computeOne(job, fragment, seconds);
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
    if (outputs)
      writeReady(job);
    job.frame().monitor.advance(1);
  }
  return failed;
}

void
FragmentRun::writeOutput(FragmentJob& job,
                         std::size_t number,
                         const std::vector<bool>& usable)
{
  QuietMonitor monitor(job.frame().monitor);
  Ledger::Entry entry;
  const auto begin = std::chrono::steady_clock::now();
  entry.figures = job.write(plan_, folder_, number, usable, &monitor);
  entry.done = true;
  entry.seconds = secondsSince(begin);
  entry.peak_bytes = peakBytes();
  ledger_.write(Ledger::output, number, entry);
}

/** Writes the outputs whose fragments are all there, and removes the results that no
 * other output needs. */
void
FragmentRun::writeReady(FragmentJob& job)
{
  std::vector<bool> done(plan_.tiling.boxes()), needed(done.size(), false);
  for (std::size_t f = 0; f < done.size(); ++f)
    done[f] = ledger_.done(Ledger::task, f);
  const auto isDone = [&](std::size_t f) { return done[f]; };
  for (std::size_t i = 0;; ++i) {
    const auto needs = job.needs(plan_, i);
    if (needs.empty())
      break;
    if (ledger_.done(Ledger::output, i))
      continue;
    if (std::all_of(needs.begin(), needs.end(), isDone))
      writeOutput(job, i, done);
    else
      for (const std::size_t f : needs)
        needed[f] = true;
  }
  for (std::size_t f = 0; f < done.size(); ++f)
    if (done[f] && !needed[f]) {
      std::error_code ignored;
      fs::remove(fragments::resultPath(folder_, f), ignored);
    }
}

std::size_t
FragmentRun::merge(FragmentJob& job, bool partial)
{
  std::vector<bool> usable(plan_.tiling.boxes());
  std::size_t missing = 0, first = 0;
  for (std::size_t f = usable.size(); f-- > 0;) {
    usable[f] = ledger_.done(Ledger::task, f);
    if (!usable[f]) {
      ++missing;
      first = f;
    }
  }
  if (missing > 0 && !partial) {
    const auto entry = ledger_.find(Ledger::task, first);
    throw std::runtime_error(
        std::to_string(missing) + " of " + std::to_string(usable.size()) +
        " fragments are not done, the first is number " + std::to_string(first) +
        (entry ? " (" + entry->reason + ")" : std::string()) +
        "; work on them, or merge the others with --partial");
  }
  std::map<std::string, double> figures;
  for (std::size_t i = 0; !job.needs(plan_, i).empty(); ++i) {
    if (!ledger_.done(Ledger::output, i))
      writeOutput(job, i, usable);
    const auto entry = ledger_.find(Ledger::output, i);
    if (!entry)
      throw std::runtime_error(ledger_.path(Ledger::output, i) + ": is gone");
    for (const auto& [name, value] : entry->figures)
      figures[name] += value;
  }
  for (std::size_t f = 0; f < usable.size(); ++f) {
    double& peak = figures["peak_bytes"];
    if (const auto entry = ledger_.find(Ledger::task, f)) {
      peak = std::max(peak, entry->peak_bytes);
      for (const auto& [name, value] : entry->figures)
        figures[name] += value;
    }
  }
  std::error_code ignored;
  fs::remove_all(fs::path(folder_) / "results", ignored);
  job.frame().summary["fragments"] = usable.size();
  job.frame().summary["fragments_missing"] = missing;
  job.report(figures);
  return missing;
}

} // namespace linelet::apps
