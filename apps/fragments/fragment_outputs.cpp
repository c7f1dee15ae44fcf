// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <stdexcept>

#include <linelet/fragments/records.h>
#include <linelet/io/unfinished_files.h>

#include "fragment_run.h"
#include "quiet_monitor.h"
#include "work_meter.h"

namespace linelet::apps {

namespace fs = std::filesystem;
using fragments::Ledger;

void
FragmentRun::writeOutput(FragmentJob& job,
                         std::size_t number,
                         const std::vector<bool>& usable)
{
  QuietMonitor monitor(job.frame().monitor);
  Ledger::Entry entry;
  const WorkMeter meter;
  entry.figures = job.write({plan_, folder_, number, usable, &monitor});
  entry.done = true;
  meter.note(entry);
  ledger_.write(Ledger::output, number, entry);
}

/** What each device did, if several shared the work. */
void
FragmentRun::summarizeDevices(Frame& frame) const
{
  struct Share {
    std::size_t fragments = 0;
    double points = 0, seconds = 0;
  };
  std::map<std::string, Share> shares;
  for (std::size_t f = 0; f < plan_.tiling.boxes(); ++f)
    if (const auto entry = ledger_.find(Ledger::task, f); entry && entry->done) {
      Share& share = shares[entry->device];
      ++share.fragments;
      share.points += entry->points;
      share.seconds += entry->seconds;
    }
  shares.erase("");
  for (const auto& [device, share] : shares) {
    std::printf("%s: %zu fragments, %.0f points in %.1f s\n",
                device.c_str(),
                share.fragments,
                share.points,
                share.seconds);
    frame.summary["devices"].push_back({{"name", device},
                                        {"fragments", share.fragments},
                                        {"points", share.points},
                                        {"seconds", share.seconds}});
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
        "; finish them with linelet work, or merge the others with --partial");
  }
  Figures figures;
  for (std::size_t i = 0; !job.needs(plan_, i).empty(); ++i) {
    if (!ledger_.done(Ledger::output, i))
      writeOutput(job, i, usable);
    const auto entry = ledger_.find(Ledger::output, i);
    if (!entry)
      throw std::runtime_error(ledger_.path(Ledger::output, i) + ": is missing");
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
  if (missing == 0) {
    ledger_.removeLocks();
    // Temporary files that killed workers left beside the outputs.
    const fs::path output = fs::path(folder_).replace_extension();
    io::removeLeftovers(fs::is_directory(output, ignored)
                            ? output.string()
                            : fs::absolute(output).parent_path().string());
  }
  job.frame().summary["fragments"] = usable.size();
  job.frame().summary["fragments_missing"] = missing;
  job.report(figures);
  summarizeDevices(job.frame());
  return missing;
}

} // namespace linelet::apps
