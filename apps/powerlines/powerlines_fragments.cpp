// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerlines_job.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include <linelet/powerline/extract_power_lines.h>
#include <linelet/powerline/find_surroundings.h>

#include "powerlines_merge.h"
#include "powerlines_part.h"

namespace linelet::apps {

using powerline::PowerLineNetwork;

namespace {

constexpr double widest_support = 16; // meters, from a wire to what continues it

} // namespace

std::string
PowerlinesJob::reference()
{
  for (const io::FileSummary& file : input_.summaries())
    if (!file.wkt.empty())
      return file.wkt;
  return {};
}

powerline::InputExtent
PowerlinesJob::extent()
{
  constexpr double none = std::numeric_limits<double>::infinity();
  powerline::InputExtent all{0, Point::Constant(none), Point::Constant(-none)};
  for (const io::FileSummary& file : input_.summaries()) {
    all.points += file.points;
    if (file.points == 0)
      continue;
    all.low = all.low.cwiseMin(file.low);
    all.high = all.high.cwiseMax(file.high);
  }
  return all;
}

void
PowerlinesJob::check()
{
  if (!(buffer_ > 0) || !std::isfinite(buffer_))
    throw std::runtime_error("--buffer must be a length, more than 0");
  if (!reviewed_.empty())
    throw std::runtime_error("--reviewed does not work in fragments; give more "
                             "--memory, or review the result");
  refuseOtherResults(powerline::otherResultsIn(folder_, extent(), output_.source));
  powerline::makeOutputFolder(folder_, output_.compress);
  warnOfUnits(reference());
}

double
PowerlinesJob::ghost(const Figures& /*measures*/)
{
  return buffer_ / io::unitsOf(reference()).plan;
}

std::size_t
PowerlinesJob::wiresCutOff(const fragments::Plan& plan,
                           const fragments::Fragment& fragment,
                           const io::Cloud& cloud,
                           const powerline::NetworkPart& part) const
{
  const powerline::MetricFrame frame(cloud);
  const auto isSeen = [&](const Point& world) {
    bool seen = false;
    plan.tiling.forEachNear(world.x(), world.y(), plan.reach(), [&](std::size_t f) {
      seen = seen || f == fragment.number;
    });
    return seen;
  };
  const auto isInput = [&](const Point& world) {
    return std::any_of(plan.inputs.begin(), plan.inputs.end(), [&](const auto& input) {
      const fragments::Area& area = input.extent.area;
      return world.x() >= area.low[0] && world.x() <= area.high[0] &&
             world.y() >= area.low[1] && world.y() <= area.high[1];
    });
  };
  const auto owns = [&](const Point& p) {
    const Point world = frame.world(p);
    return plan.tiling.owner(world.x(), world.y()) == fragment.number;
  };
  std::size_t count = 0;
  for (const powerline::LooseWire& loose : part.wires) {
    const powerline::Wire& wire = loose.wire;
    bool own = owns(wire.curve.at((wire.curve.from + wire.curve.to) / 2));
    for (const powerline::LooseWire::End& end : loose.ends)
      if (end.support >= 0)
        own = own || owns(part.supports[static_cast<std::size_t>(end.support)].base);
    const Point on = widest_support * (wire.back - wire.front).normalized();
    for (const bool front : {true, false}) {
      const Point beyond =
          frame.world(front ? Point(wire.front - on) : Point(wire.back + on));
      if (own && loose.ends[front ? 0 : 1].support < 0 && isInput(beyond) &&
          !isSeen(beyond)) {
        ++count;
        break;
      }
    }
  }
  return count;
}

Figures
PowerlinesJob::compute(const FragmentTask& task)
{
  io::Cloud cloud;
  cloud.shift = task.plan.shift;
  cloud.wkt = reference();
  cloud.points = std::move(task.fragment.points);
  cloud.set({"classification", task.fragment.classes, ""});
  if (std::any_of(task.fragment.returns.begin(),
                  task.fragment.returns.end(),
                  [](auto n) { return n > 0; }))
    cloud.set({"number_of_returns", task.fragment.returns, ""});
  powerline::PowerLineSettings settings = settings_;
  settings.threads = frame_.threads; // of this worker
  PowerlinesPart part;
  const PowerLineNetwork network =
      powerline::extractPowerLines(cloud, settings, task.monitor, &part.network);
  const io::UsablePoints usable(cloud, nullptr, settings.points);
  part.surroundings = ownSurroundings(
      task.fragment,
      cloud,
      powerline::findSurroundings(network,
                                  cloud,
                                  usable,
                                  powerline::limitsOf(hazards_, settings_.clearance),
                                  hazards_.classes,
                                  frame_.threads,
                                  task.monitor));
  // All fragments together keep half as many points as one fragment may hold.
  const auto most = static_cast<std::size_t>(std::ceil(
      task.plan.most_points / (2 * static_cast<double>(task.plan.tiling.boxes()))));
  part.picture = picturePoints(task.fragment, cloud, network, most);
  const std::size_t cut_off =
      wiresCutOff(task.plan, task.fragment, cloud, part.network);
  savePart(task.result, task.fragment, network, std::move(part));
  return {{"cut_off", static_cast<double>(cut_off)}};
}

Figures
PowerlinesJob::write(const OutputTask& task)
{
  const PowerlinesMerge merge(task.plan, task.folder, task.usable, reference());
  std::vector<std::string> warnings;
  std::vector<std::string> files = powerline::powerLineFiles(folder_, output_.compress);
  const CopiedPoints copied = merge.writeClassified(
      files.front(), input_, output_.classes, &warnings, task.monitor);
  output_.input = extent();
  output_.hazards = powerline::findHazardsAtStates(merge.network(),
                                                   merge.surroundings(),
                                                   hazards_,
                                                   settings_.clearance,
                                                   frame_.threads,
                                                   task.monitor);
  powerline::writeNetworkFiles(
      folder_, merge.pictures(), merge.network(), output_, &warnings, task.monitor);
  powerline::warnOfDoubts(
      merge.network(), copied.unconfirmed, output_.classes, &warnings);
  std::sort(warnings.begin(), warnings.end());
  warnings.erase(std::unique(warnings.begin(), warnings.end()), warnings.end());
  frame_.warn(warnings);
  tell(merge.network(), copied.points, files);
  return {{"points", copied.points}};
}

void
PowerlinesJob::report(const Figures& figures)
{
  const auto cut_off = figures.find("cut_off");
  if (cut_off != figures.end() && cut_off->second > 0) {
    char text[200];
    std::snprintf(text,
                  sizeof text,
                  "%.0f wires extend beyond the overlap of their fragments (%g m) and "
                  "may be joined wrongly; make --buffer longer than the longest span",
                  cut_off->second,
                  buffer_);
    frame_.warn(text);
  }
}

} // namespace linelet::apps
