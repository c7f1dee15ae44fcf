// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fragment_run.h"

#include <filesystem>
#include <utility>

#include "plan_job.h"
#include "version.h"

namespace linelet::apps {

namespace fs = std::filesystem;

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
    throw io::FileError(
        run.folder_ +
        ": belongs to other inputs, options or another version of linelet; "
        "run without --resume to start over");
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
    throw io::FileError(run.plan_.place +
                        ": the run was planned here, but the folder cannot be entered; "
                        "mount it under the same path");
  job = makeFragmentJob(run.plan_.command, run.plan_.arguments);
  job->check();
  return run;
}

void
FragmentRun::remove() const
{
  std::error_code ignored;
  // The plan goes first: if killed in between, nothing remains that looks like a run.
  fs::remove(fs::path(folder_) / "plan.json", ignored);
  fs::remove_all(folder_, ignored);
}

} // namespace linelet::apps
