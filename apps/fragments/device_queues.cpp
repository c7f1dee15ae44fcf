// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "device_queues.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "work_meter.h"

namespace linelet::apps {

using fragments::Fragment;
using fragments::TimePrediction;

namespace {

// Size of the larger part: large enough that a device's startup hardly matters.
constexpr std::size_t part_size = 100000;

/** \brief The first \a count points of \a fragment, which all belong to it. */
Fragment
firstOf(const Fragment& fragment, std::size_t count)
{
  const auto head = [count](const auto& list) {
    return std::decay_t<decltype(list)>(
        list.begin(), list.begin() + static_cast<std::ptrdiff_t>(count));
  };
  Fragment part;
  part.number = fragment.number;
  part.points = head(fragment.points);
  part.classes = head(fragment.classes);
  part.returns = head(fragment.returns);
  part.places = head(fragment.places);
  part.core.assign(count, true);
  for (fragments::Section section : fragment.sections)
    if (section.first < count) {
      section.count = std::min(section.count, count - section.first);
      part.sections.push_back(section);
    }
  return part;
}

/** \brief Points of every task; 0 where they cannot be read, which the computation
 * reports. */
std::vector<double>
pointsOf(const fragments::Pieces& pieces,
         const std::vector<std::size_t>& tasks,
         ProgressMonitor* monitor)
{
  std::vector<double> points;
  for (const std::size_t task : tasks)
    try {
      points.push_back(static_cast<double>(pieces.points(task, monitor)));
    }
    catch (const Canceled&) {
      throw;
    }
    catch (const std::exception&) {
      throwIfCanceled(monitor);
      points.push_back(0);
    }
  return points;
}

/** \brief The largest fragment, or nothing if it cannot be read. */
std::optional<Fragment>
sampleOf(const fragments::Pieces& pieces,
         const std::vector<std::size_t>& tasks,
         const std::vector<double>& points,
         ProgressMonitor* monitor)
{
  const auto largest = std::max_element(points.begin(), points.end());
  if (!(*largest > 0))
    return {};
  try {
    return pieces.load(tasks[static_cast<std::size_t>(largest - points.begin())],
                       monitor);
  }
  catch (const Canceled&) {
    throw;
  }
  catch (const std::exception&) {
    throwIfCanceled(monitor);
    return {};
  }
}

/** \brief How long a device takes, measured on parts of \a sample. */
TimePrediction
measured(FragmentJob& job,
         const fragments::Plan& plan,
         const Fragment& sample,
         std::size_t device,
         const std::string& scratch,
         ProgressMonitor* monitor)
{
  const std::size_t most = std::min(sample.points.size(), part_size);
  TimePrediction seconds;
  for (const std::size_t share : {16, 4, 1}) {
    Fragment part = firstOf(sample, std::max<std::size_t>(1, most / share));
    const auto points = static_cast<double>(part.points.size());
    const WorkMeter meter;
    job.compute({plan, part, device, scratch, monitor});
    if (share != 16) // the first call builds programs
      seconds.add(points, meter.seconds());
  }
  return seconds;
}

} // namespace

DeviceQueues
shareOut(FragmentJob& job,
         const fragments::Plan& plan,
         const fragments::Pieces& pieces,
         const std::vector<std::size_t>& tasks,
         const std::string& scratch,
         ProgressMonitor* monitor)
{
  const FragmentJob::Devices wanted = job.devices();
  std::vector<std::size_t> devices = {0};
  const auto inOrder = [&] {
    fragments::Schedule schedule;
    for (std::size_t k = 0; k < tasks.size(); ++k)
      schedule.push_back({k, 0, 0, 0});
    return DeviceQueues{devices, {schedule, 1}};
  };
  if (wanted.names.size() < 2 || tasks.size() < 2)
    return inOrder();
  const std::vector<double> points = pointsOf(pieces, tasks, monitor);
  const std::optional<Fragment> sample = sampleOf(pieces, tasks, points, monitor);
  if (!sample)
    return inOrder();
  std::vector<TimePrediction> seconds;
  devices.clear();
  for (std::size_t d = 0; d < wanted.names.size(); ++d)
    try {
      seconds.push_back(measured(job, plan, *sample, d, scratch, monitor));
      devices.push_back(d);
    }
    catch (const Canceled&) {
      throw;
    }
    catch (const std::exception& error) {
      throwIfCanceled(monitor);
      job.frame().warn(wanted.names[d] + " is left out: " + error.what());
    }
  std::error_code ignored;
  std::filesystem::remove(scratch, ignored);
  if (devices.empty()) // the computation reports why
    devices = {0};
  if (devices.size() == 1)
    return inOrder();
  fragments::ExpectedTimes times(tasks.size(), devices.size());
  for (std::size_t k = 0; k < tasks.size(); ++k)
    for (std::size_t d = 0; d < devices.size(); ++d)
      times(k, d) = seconds[d](points[k]);
  return {devices, fragments::dispatcherFor(wanted.heuristic, times, points)};
}

} // namespace linelet::apps
