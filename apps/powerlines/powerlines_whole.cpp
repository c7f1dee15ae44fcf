// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerlines_job.h"

#include <utility>

#include <linelet/powerline/extract_power_lines.h>
#include <linelet/powerline_output/review_file.h>

namespace linelet::apps {

using powerline::PowerLineNetwork;

int
PowerlinesJob::runWhole()
{
  io::Cloud cloud = input_.read();
  refuseOtherResults(powerline::otherResultsIn(folder_, cloud, output_.source));
  powerline::makeOutputFolder(folder_, output_.compress);
  warnOfUnits(cloud.wkt);
  const io::UsablePoints usable = input_.usable(cloud);
  const std::size_t withheld = usable.withheld(), ignored = usable.ignored();
  const std::size_t points = cloud.points.size();
  const auto judged = reviewed_.empty() ? std::vector<powerline::ReviewedWire>()
                                        : powerline::readReview(reviewed_, cloud);
  powerline::NetworkPart as_in_fragments; // the same seeds
  PowerLineNetwork network =
      powerline::extractPowerLines(cloud, settings_, &frame_.monitor, &as_in_fragments);
  for (const std::string& sentence : powerline::applyReview(network, judged))
    frame_.warn(reviewed_ + ": " + sentence);
  frame_.lap("powerlines");
  frame_.monitor.begin("hazards", 0);
  output_.hazards = powerline::findHazardsAtStates(network,
                                                   cloud,
                                                   usable,
                                                   hazards_,
                                                   settings_.clearance,
                                                   frame_.threads,
                                                   &frame_.monitor);
  frame_.lap("hazards");
  std::vector<std::string> warnings;
  const std::vector<std::string> files = powerline::writePowerLineFiles(
      folder_, std::move(cloud), network, output_, &warnings, &frame_.monitor);
  frame_.warn(warnings);
  frame_.lap("write");
  tell(network, static_cast<double>(points), files);
  frame_.summary["withheld"] = withheld;
  frame_.summary["ignored"] = ignored;
  return frame_.finish();
}

} // namespace linelet::apps
