// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <charconv>
#include <cstdio>
#include <cstdlib>

#include "commands.h"
#include "fragment_run.h"
#include "options.h"

namespace linelet::apps {

namespace {

std::size_t
numberIn(const std::string& text, const char* option)
{
  std::size_t number = 0;
  const char* end = text.data() + text.size();
  const auto [behind, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || behind != end)
    throw std::invalid_argument(std::string(option) + " is '" + text +
                                "', it must be the number of a fragment");
  return number;
}

/** \brief Two numbers separated by \a between: "A-B" or "K/N". */
std::pair<std::size_t, std::size_t>
pairIn(const std::string& text, char between, const char* option)
{
  std::size_t one = 0, other = 0;
  char sign = 0, behind = 0;
  const int got = std::sscanf(text.c_str(), "%zu%c%zu%c", &one, &sign, &other, &behind);
  if (got != 3 || sign != between || text[0] == '-')
    throw std::invalid_argument(std::string(option) + " is '" + text +
                                "', it must be " + (between == '/' ? "K/N" : "A-B"));
  return {one, other};
}

} // namespace

int
runWork(const std::vector<std::string>& arguments)
{
  Frame frame("work",
              "Processes a plan: all fragments that are not done, or some. Any "
              "number of workers may run at once, on machines that share the files; "
              "finished fragments are skipped, and two workers on one fragment write "
              "the same. Fragments are numbered from 0.");
  std::string place, task, range, every;
  frame.addArgument("OUTPUT", place, "what was planned as the output");
  const OptionAdder add(frame.app);
  add("task", task, "only the fragment of this number");
  add("tasks", range, "only fragments A to B, as A-B");
  add("every",
      every,
      "only every N-th fragment, as worker K of N: K/N, counting from 1; auto: K and N "
      "as mpirun or Slurm set them");
  frame.parse(arguments);
  if (!task.empty() && !(range.empty() && every.empty()))
    throw std::invalid_argument("--task excludes --tasks and --every");
  std::unique_ptr<FragmentJob> job;
  FragmentRun run = FragmentRun::open(place, job);
  if (frame.threads > 0)
    job->frame().threads = frame.threads;
  const std::size_t count = run.plan().tiling.boxes();
  std::size_t first = 0, last = count - 1, step = 1;
  if (!task.empty())
    first = last = numberIn(task, "--task");
  if (!range.empty())
    std::tie(first, last) = pairIn(range, '-', "--tasks");
  if (first >= count)
    throw std::runtime_error("there is no fragment " + std::to_string(first) + ", " +
                             std::to_string(count) + " are planned");
  last = std::min(last, count - 1);
  if (every == "auto") {
    for (const auto& [rank, size] :
         {std::pair("OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"),
          std::pair("SLURM_PROCID", "SLURM_NTASKS")})
      if (std::getenv(rank) != nullptr && std::getenv(size) != nullptr) {
        every =
            std::to_string(std::atoi(std::getenv(rank)) + 1) + "/" + std::getenv(size);
        break;
      }
    if (every == "auto")
      throw std::runtime_error("--every auto: neither mpirun nor Slurm started this");
  }
  if (!every.empty()) {
    const auto [worker, workers] = pairIn(every, '/', "--every");
    if (worker < 1 || worker > workers)
      throw std::invalid_argument("--every is '" + every + "', K must be 1 to N");
    first += worker - 1;
    step = workers;
  }
  std::vector<std::size_t> tasks;
  for (std::size_t t = first; t <= last; t += step)
    tasks.push_back(t);
  run.ledger().forgetFailures();
  const auto failed = run.work(*job, tasks, false);
  std::printf("%s: %zu fragments, %zu failed\n",
              run.folder().c_str(),
              tasks.size(),
              failed.size());
  for (const std::size_t number : failed)
    std::fprintf(stderr,
                 "linelet work: fragment %zu: %s\n",
                 number,
                 run.ledger().find(fragments::Ledger::task, number)->reason.c_str());
  frame.summary["fragments"] = tasks.size();
  frame.summary["failed"] = failed;
  const int code = frame.finish();
  return failed.empty() ? code : 1;
}

} // namespace linelet::apps
