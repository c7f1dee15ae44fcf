// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/powerline/extract_power_lines.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <limits>
#include <stdexcept>
#include <string>

#include <linelet/io/usable_points.h>
#include <linelet/powerline/metric_frame.h>
#include <linelet/support/text.h>
#include <linelet/support/threads.h>

#include "powerline/false_positives/false_positives.h"
#include "powerline/false_positives/misled.h"
#include "powerline/false_positives/unlikely.h"
#include "powerline/fittings/fittings.h"
#include "powerline/network/clearances.h"
#include "powerline/network/describe_supports.h"
#include "powerline/network/describe_wires.h"
#include "powerline/network/label_points.h"
#include "powerline/network/loose_wires.h"
#include "powerline/network/number_wires.h"
#include "powerline/network/unexplained.h"
#include "powerline/pieces/bundles.h"
#include "powerline/pieces/candidates.h"
#include "powerline/pieces/chords.h"
#include "powerline/pieces/curve_pieces.h"
#include "powerline/pieces/explanations.h"
#include "powerline/pieces/find_pieces.h"
#include "powerline/pieces/growth.h"
#include "powerline/pieces/merge.h"
#include "powerline/pieces/next_spans.h"
#include "powerline/pieces/parallel_wires.h"
#include "powerline/spans/company.h"
#include "powerline/spans/completion.h"
#include "powerline/spans/joints.h"
#include "powerline/spans/mend_breaks.h"
#include "powerline/spans/service_drops.h"
#include "powerline/spans/spans_between.h"
#include "powerline/spans/split_at_poles.h"
#include "powerline/spans/wire_with_ends.h"
#include "powerline/supports/carry_to_supports.h"
#include "powerline/supports/place_order.h"
#include "powerline/supports/tower.h"
#include "powerline/supports/towers.h"
#include "powerline/terrain/find_ground.h"
#include "powerline/terrain/shows_terrain.h"
#include "powerline/terrain/underside.h"
#include "support/quiet_monitor.h"

namespace linelet::powerline {

namespace {

constexpr double wire_height = 4; // meters, wires hang higher than this on average

void
require(bool in_order, const char* name, double value, const char* range)
{
  if (!in_order)
    throw std::invalid_argument(std::string(name) + " is " + textOf(value) +
                                ", it must be " + range);
}

void
check(const PowerLineSettings& s)
{
  require(
      std::isfinite(s.clearance) && s.clearance >= 0, "clearance", s.clearance, ">= 0");
  require(std::isfinite(s.max_gap) && s.max_gap >= 2, "max-gap", s.max_gap, ">= 2");
  require(std::isfinite(s.min_height) && s.min_height >= 0.5,
          "min-height",
          s.min_height,
          ">= 0.5");
  require(std::isfinite(s.min_length) && s.min_length >= 5,
          "min-length",
          s.min_length,
          ">= 5");
}

/** Reports the stages to the monitor and records their times. */
class Stages {
public:
  Stages(PowerLineNetwork& network, ProgressMonitor* monitor)
      : network_(network), monitor_(monitor)
  {
  }

  ~Stages() { finish(); }

  void
  begin(const char* stage)
  {
    finish();
    if (monitor_ != nullptr) {
      if (monitor_->canceled())
        throw Canceled();
      monitor_->begin(stage, 0);
    }
    network_.stages.push_back({stage, 0});
    begun_ = Clock::now();
  }

private:
  using Clock = std::chrono::steady_clock;

  void
  finish()
  {
    if (!network_.stages.empty())
      network_.stages.back().seconds +=
          std::chrono::duration<double>(Clock::now() - begun_).count();
  }

  PowerLineNetwork& network_;
  ProgressMonitor* monitor_;
  Clock::time_point begun_;
};

// The ground that heights are measured from. The network gets it too. If there is none,
// heights are measured from so far below that every point may be part of a wire.
Ground
groundUnder(const Points& points,
            const std::vector<std::uint8_t>& classes,
            const PowerLineSettings& settings,
            PowerLineNetwork& network,
            const ProgressMonitor* monitor)
{
  const bool terrain = showsTerrain(points, classes);
  Ground ground = findGround(
      points, classes, settings.use_classes, monitor, terrain, settings.threads);
  throwIfCanceled(monitor);
  if (terrain)
    network.ground = ground;
  else
    for (float& height : ground.heights)
      height -= static_cast<float>(std::max(settings.min_height, wire_height) + 1);
  return ground;
}

} // namespace

PowerLineNetwork
extractPowerLines(const Points& points,
                  const std::vector<std::uint8_t>& classes,
                  const PowerLineSettings& settings,
                  ProgressMonitor* monitor,
                  NetworkPart* part)
{
  check(settings);
  if (!classes.empty() && classes.size() != points.size())
    throw std::invalid_argument(std::to_string(classes.size()) + " classes for " +
                                std::to_string(points.size()) +
                                " points; there must be one for each or none");
  PowerLineNetwork network;
  network.classes = classes;
  network.classes.resize(points.size(), 0);
  for (std::uint8_t& number : network.classes)
    if (number == wire_class || number == pylon_class)
      number = unclassified; // until found
  network.wire_id.assign(points.size(), 0);
  network.span_id.assign(points.size(), 0);
  network.wire_distance.assign(points.size(), std::numeric_limits<float>::quiet_NaN());
  {
    Stages stages(network, monitor);
    stages.begin("ground");
    const Ground ground = groundUnder(points, classes, settings, network, monitor);
    stages.begin("index");
    const Candidates candidates =
        findCandidates(points, ground, settings.min_height, settings.threads);
    throwIfCanceled(monitor);
    const Underside underside(points);
    stages.begin("seeds");
    const std::vector<Seed> seeds = findSeeds(candidates, settings.threads, monitor);
    stages.begin("curves");
    Growth growth(candidates, settings, seeds);
    QuietMonitor quiet(monitor);
    // In parallel with the curves; what grows depends on what grew before.
    auto grown = std::async(threadCount(settings.threads) > 1 ? std::launch::async
                                                              : std::launch::deferred,
                            [&] { return growAll(growth, seeds, settings, &quiet); });
    std::vector<Curve> curves = curvesOf(candidates, settings, monitor);
    stages.begin("wires");
    std::vector<Piece> pieces = grown.get();
    growth.release();
    std::vector<Piece> along;
    growAlong(curves, growth, along, settings);
    pieces = likelierPieces(growth, std::move(pieces), std::move(along), settings);
    growAlong(curves, growth, pieces, settings);
    std::vector<SeenLine> lines;
    for (const Curve& curve : curves)
      lines.push_back({curve.points, curve.noise});
    stages.begin("bundles");
    mergePieces(growth, pieces, settings);
    throwIfCanceled(monitor);
    dropChords(growth, pieces);
    addNextSpans(growth, pieces, underside, settings, monitor);
    addParallelWires(growth, pieces, settings);
    throwIfCanceled(monitor);
    addBundles(growth, seeds, pieces, settings);
    mergePieces(growth, pieces, settings);
    std::vector<WireWithEnds> with_ends;
    for (Strand& strand : sortBundles(growth, std::move(pieces), settings))
      with_ends.push_back({std::move(strand), {}});
    stages.begin("supports");
    joinBesideCompany(with_ends, growth, settings);
    completeByCompany(with_ends, growth, settings);
    matchEnds(with_ends);
    if (addSpansBetween(with_ends, growth, underside, settings))
      matchEnds(with_ends);
    if (addSpansBeside(with_ends, growth, underside, settings))
      matchEnds(with_ends);
    throwIfCanceled(monitor);
    splitAtPoles(with_ends, growth, settings.threads);
    throwIfCanceled(monitor);
    for (const WireWithEnds& wire : with_ends)
      lines.push_back(seenLine(wire.strand.piece));
    dropFalsePositives(with_ends, growth, points, ground, settings.min_height);
    matchEnds(with_ends);
    throwIfCanceled(monitor);
    const bool terrain = !network.ground.heights.empty();
    dropUnlikely(with_ends, growth, underside, terrain, settings);
    throwIfCanceled(monitor);
    addStubs(with_ends, growth, seeds, curves, underside, terrain, settings);
    matchEnds(with_ends);
    if (mendBreaks(with_ends, growth, settings))
      matchEnds(with_ends);
    if (addServiceDrops(with_ends, growth, seeds, curves, underside, terrain, settings))
      matchEnds(with_ends);
    throwIfCanceled(monitor);
    std::vector<Tower> towers = buildTowers(with_ends, growth, ground, settings);
    if (dropMisled(with_ends, growth)) {
      matchEnds(with_ends);
      towers = buildTowers(with_ends, growth, ground, settings);
    }
    carryBesideCompany(with_ends, towers, growth, underside, settings);
    carryDropsHome(with_ends, growth);
    sortByPlace(with_ends, towers);
    stages.begin("catenaries");
    network.supports = describeSupports(towers, terrain);
    network.wires = describeWires(with_ends, growth, settings);
    std::vector<Wire> unnumbered;
    if (part != nullptr)
      unnumbered = network.wires;
    const std::vector<int> ids = numberWires(network, with_ends);
    stages.begin("labels");
    labelPoints(network, points, with_ends, ids, towers, growth);
    findFittings(network, candidates, settings.threads);
    findUnexplained(network, lines, candidates, settings);
    stages.begin("clearances");
    measureClearances(network, candidates, settings);
    if (part != nullptr)
      *part = partOf(network, with_ends, std::move(unnumbered), ids, candidates.points);
  }
  return network;
}

PowerLineNetwork
extractPowerLines(const io::Cloud& cloud,
                  const PowerLineSettings& settings,
                  ProgressMonitor* monitor,
                  NetworkPart* part)
{
  std::vector<std::uint8_t> classes;
  if (const io::Column* column = cloud.find("classification")) {
    classes.resize(cloud.points.size());
    std::visit(
        [&](const auto& values) {
          std::transform(values.begin(), values.end(), classes.begin(), [](auto value) {
            return static_cast<std::uint8_t>(static_cast<double>(value));
          });
        },
        column->values);
  }
  const MetricFrame frame(cloud);
  const io::UsablePoints usable(cloud, nullptr, settings.points);
  if (frame.units().areMeters())
    return extractPowerLines(usable.points(), classes, settings, monitor, part);
  Points points(cloud.points.size());
  std::transform(usable.points().begin(),
                 usable.points().end(),
                 points.begin(),
                 [&](const Point& p) { return frame.meters(p); });
  return extractPowerLines(points, classes, settings, monitor, part);
}

} // namespace linelet::powerline
