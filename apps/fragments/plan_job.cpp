// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "plan_job.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <linelet/io/cloud_sink.h>

#include "version.h"

namespace linelet::apps {

namespace {

bool
isLas(const std::string& path)
{
  return io::CloudSink::takes(path); // the same endings
}

/** The extent in a file's header, enlarged since some programs round it. */
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

} // namespace

bool
wantsFragments(FragmentJob& job)
{
  const FragmentOptions& options = job.options();
  if (options.chunk > 0 || options.resume || job.devices().names.size() > 1)
    return true;
  double points = 0;
  for (const std::string& file : job.input().files())
    if (!isLas(file))
      return false; // other headers are slow to read
  try {
    for (const io::FileSummary& file : job.input().summaries())
      points += static_cast<double>(file.points);
  }
  catch (const io::FileError&) {
    return false; // reported when the file is read, after the outputs have been checked
  }
  return points * job.bytesPerPoint().in_one_piece > options.memory.bytes();
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
  plan.place = std::filesystem::current_path().string();
  plan.measures = job.measures();
  plan.ghost = job.ghost(plan.measures);
  // Memory besides the points: the program, its tables, and a block of the input.
  constexpr double base = 250e6;
  const double memory = job.options().memory.bytes();
  const auto devices = static_cast<double>(job.devices().names.size());
  plan.most_points = std::max(memory - base, memory / 8) /
                     (devices * job.bytesPerPoint().in_fragments);
  std::vector<fragments::Extent> extents;
  for (const io::FileSummary& file : job.input().summaries()) {
    plan.inputs.push_back(plannedInput(file));
    if (file.points > 0)
      extents.push_back(plan.inputs.back().extent);
  }
  plan.shift = job.input().shift();
  double most_points = plan.most_points;
  if (devices > 1) {
    // Enough of them that no device waits long for the last.
    constexpr double per_device = 8;
    double points = 0;
    for (const fragments::Extent& extent : extents)
      points += extent.points;
    most_points = std::min(most_points, points / (per_device * devices));
  }
  plan.tiling =
      fragments::Tiling(extents, {plan.ghost, job.options().chunk, most_points});
  return plan;
}

} // namespace linelet::apps
