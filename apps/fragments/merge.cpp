// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "commands.h"
#include "fragment_run.h"
#include "options.h"

namespace linelet::apps {

int
runMerge(const std::vector<std::string>& arguments)
{
  Frame frame(
      "merge",
      "Writes the results of a plan whose fragments are done; with --partial, also "
      "if some are not (the exit code is then 1).");
  std::string place;
  bool partial = false;
  frame.addArgument("OUTPUT", place, "what was planned as the output");
  OptionAdder(frame.app)("partial", partial, "leave out fragments that are not done");
  frame.parse(arguments);
  std::unique_ptr<FragmentJob> job;
  FragmentRun run = FragmentRun::open(place, job);
  const std::size_t missing = run.merge(*job, partial);
  if (missing > 0)
    frame.warn(std::to_string(missing) + " fragments are missing from the results");
  frame.summary = job->frame().summary;
  const int code = frame.finish();
  return missing == 0 ? code : 1;
}

} // namespace linelet::apps
