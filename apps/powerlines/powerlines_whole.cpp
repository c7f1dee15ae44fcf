// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerlines_job.h"

#include <algorithm>
#include <filesystem>
#include <future>
#include <utility>

#include <linelet/io/cloud_sink.h>
#include <linelet/io/merge.h>
#include <linelet/powerline/extract_power_lines.h>
#include <linelet/powerline_output/review_file.h>
#include <linelet/support/threads.h>

#include "classified_copy.h"

namespace linelet::apps {

using powerline::PowerLineNetwork;

namespace {

/** Whether the points can be read again for writing; pipes cannot. */
bool
canBeReadAgain(const std::vector<std::string>& files)
{
  return std::all_of(files.begin(), files.end(), [](const std::string& file) {
    std::error_code ignored;
    return io::CloudSink::takes(file) &&
           std::filesystem::is_regular_file(file, ignored);
  });
}

/** The labels that \a network gives to the points of a cloud, block by block. */
class LabelsInOrder {
public:
  explicit LabelsInOrder(const PowerLineNetwork& network) : network_(network) {}

  /** \throws io::FileError if the number of points has changed */
  void
  take(std::size_t count, PowerLineNetwork& found)
  {
    if (count > network_.classes.size() - next_)
      changed();
    const auto copy = [&](const auto& from, auto& to) {
      const auto begin = from.begin() + static_cast<std::ptrdiff_t>(next_);
      to.assign(begin, begin + static_cast<std::ptrdiff_t>(count));
    };
    copy(network_.classes, found.classes);
    copy(network_.wire_id, found.wire_id);
    copy(network_.span_id, found.span_id);
    copy(network_.wire_distance, found.wire_distance);
    copy(network_.is_unexplained, found.is_unexplained);
    next_ += count;
  }

  void
  finish() const
  {
    if (next_ != network_.classes.size())
      changed();
  }

private:
  [[noreturn]] static void
  changed()
  {
    throw io::FileError("the input changed while it was being processed; run it again");
  }

  const PowerLineNetwork& network_;
  std::size_t next_ = 0;
};

} // namespace

std::size_t
PowerlinesJob::copyInput(const PowerLineNetwork& network,
                         const Point& shift,
                         const std::string& wkt,
                         std::vector<std::string>* warnings)
{
  io::ReadOptions options = input_.readOptions();
  options.shift = shift;
  options.attributes.reset();
  LabelsInOrder labels(network);
  const CopiedPoints copied = copyClassified(
      powerline::powerLineFiles(folder_, output_.compress).front(),
      input_.files(),
      options,
      output_.classes,
      wkt,
      network.wires,
      [&](std::size_t, const io::Cloud& cloud, PowerLineNetwork& found) {
        labels.take(cloud.points.size(), found);
      },
      warnings,
      &frame_.monitor);
  labels.finish();
  return copied.unconfirmed;
}

std::size_t
PowerlinesJob::writeInOnePiece(const PowerLineNetwork& network,
                               const Point& shift,
                               const std::string& wkt,
                               std::vector<std::string>* warnings)
{
  io::ReadOptions all = input_.readOptions();
  all.shift = shift;
  all.attributes.reset();
  io::Cloud cloud;
  for (const std::string& file : input_.files()) {
    io::Cloud more = io::readCloud(file, all, warnings, &frame_.monitor);
    if (cloud.las == nullptr)
      cloud = std::move(more);
    else
      io::append(cloud, more, warnings);
  }
  if (cloud.wkt.empty())
    cloud.wkt = wkt;
  const std::size_t unconfirmed = powerline::classify(cloud, network, output_.classes);
  io::WriteOptions options;
  options.threads = frame_.threads;
  io::writeCloud(powerline::powerLineFiles(folder_, output_.compress).front(),
                 cloud,
                 options,
                 warnings,
                 &frame_.monitor);
  return unconfirmed;
}

int
PowerlinesJob::runWhole()
{
  const bool again = canBeReadAgain(input_.files());
  if (again)
    input_.readOnly({"number_of_returns"});
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
  const std::vector<std::string> files =
      powerline::powerLineFiles(folder_, output_.compress);
  if (again) {
    std::vector<std::string> of_cloud;
    // In parallel with the layers, which GDAL writes one by one.
    auto copied = std::async(threadCount(frame_.threads) > 1 ? std::launch::async
                                                             : std::launch::deferred,
                             [&, shift = cloud.shift, wkt = cloud.wkt] {
                               return copyInput(network, shift, wkt, &of_cloud);
                             });
    powerline::writeNetworkFiles(
        folder_, cloud, network, output_, &warnings, &frame_.monitor);
    std::size_t unconfirmed = 0;
    try {
      unconfirmed = copied.get();
    }
    catch (const io::PartsDiffer&) {
      const Point shift = cloud.shift;
      const std::string wkt = cloud.wkt;
      cloud = {};
      unconfirmed = writeInOnePiece(network, shift, wkt, &of_cloud);
    }
    powerline::warnOfDoubts(network, unconfirmed, output_.classes, &warnings);
    warnings.insert(warnings.end(), of_cloud.begin(), of_cloud.end());
  }
  else
    powerline::writePowerLineFiles(
        folder_, std::move(cloud), network, output_, &warnings, &frame_.monitor);
  frame_.warn(warnings);
  frame_.lap("write");
  tell(network, static_cast<double>(points), files);
  frame_.summary["withheld"] = withheld;
  frame_.summary["ignored"] = ignored;
  return frame_.finish();
}

} // namespace linelet::apps
