// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstdio>

#include "commands.h"
#include "fragment_run.h"

namespace linelet::apps {

int
runStatus(const std::vector<std::string>& arguments)
{
  Frame frame(
      "status",
      "Shows the progress of a plan: fragments done, failed and left, their time and "
      "memory, and why some failed. The exit code is 0 once all are done.");
  std::string place;
  frame.addArgument("OUTPUT", place, "what was planned as the output");
  frame.parse(arguments);
  using fragments::Ledger;
  const std::string folder = FragmentRun::folderOf(place);
  const fragments::Plan plan = fragments::loadPlan(folder);
  const Ledger ledger(folder, plan.fingerprint());
  const std::size_t count = plan.tiling.boxes();
  std::size_t done = 0;
  double points = 0, seconds = 0, peak = 0;
  auto failed = nlohmann::ordered_json::array();
  for (std::size_t f = 0; f < count; ++f) {
    const auto entry = ledger.find(Ledger::task, f);
    if (!entry)
      continue;
    done += entry->done ? 1 : 0;
    points += entry->points;
    seconds += entry->seconds;
    peak = std::max(peak, entry->peak_bytes);
    if (!entry->done)
      failed.push_back({{"fragment", f}, {"reason", entry->reason}});
  }
  std::printf("%s: linelet %s, %zu fragments: %zu done, %zu failed, %zu left\n"
              "%.0f points in %.1f s of computing, at most %.0f MB\n",
              folder.c_str(),
              plan.command.c_str(),
              count,
              done,
              failed.size(),
              count - done - failed.size(),
              points,
              seconds,
              peak / 1e6);
  for (const auto& one : failed)
    std::printf("fragment %zu: %s\n",
                one["fragment"].get<std::size_t>(),
                one["reason"].get<std::string>().c_str());
  frame.summary["command"] = plan.command;
  frame.summary["fragments"] = count;
  frame.summary["done"] = done;
  frame.summary["failed"] = failed;
  frame.summary["left"] = count - done - failed.size();
  frame.summary["points"] = points;
  frame.summary["seconds_computing"] = seconds;
  frame.summary["peak_bytes"] = peak;
  const int code = frame.finish();
  return done == count ? code : 1;
}

} // namespace linelet::apps
