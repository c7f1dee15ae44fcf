// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdio>

#include "commands.h"
#include "fragment_run.h"

namespace linelet::apps {

int
runPlan(const std::vector<std::string>& arguments)
{
  if (arguments.empty() || arguments.front().rfind('-', 0) == 0) {
    std::string command;
    Frame frame("plan",
                "Plans a command in fragments from headers alone (curves reads the "
                "points once): "
                "linelet plan "
                "COMMAND, followed by the arguments of that command, as in linelet "
                "plan tensor --radius 1 --memory 4G tiles/ out/. The plan is kept in "
                "OUTPUT.fragments; linelet work OUTPUT processes it, linelet merge "
                "OUTPUT writes the results, linelet status OUTPUT shows the progress.");
    frame.addArgument("COMMAND", command, "tensor, multiscale, curves or powerlines");
    frame.parse(arguments);
    return 2;
  }
  const std::vector<std::string> rest(arguments.begin() + 1, arguments.end());
  const auto job = makeFragmentJob(arguments.front(), rest);
  job->check();
  const FragmentRun run = FragmentRun::make(
      *job, arguments.front(), rest, FragmentRun::Existing::KeepOrReplace);
  double points = 0;
  for (const auto& input : run.plan().inputs)
    points += input.extent.points;
  const std::size_t count = run.plan().tiling.boxes();
  std::printf("%s: %zu fragments of %zu files, %.0f points, ghost zones of %.6g\n",
              run.folder().c_str(),
              count,
              run.plan().inputs.size(),
              points,
              run.plan().ghost);
  Frame& frame = job->frame();
  frame.summary["folder"] = run.folder();
  frame.summary["fragments"] = count;
  frame.summary["files"] = run.plan().inputs.size();
  frame.summary["points"] = points;
  frame.summary["ghost"] = run.plan().ghost;
  return frame.finish();
}

} // namespace linelet::apps
