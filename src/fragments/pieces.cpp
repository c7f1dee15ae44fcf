// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/fragments/pieces.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include <linelet/io/file_error.h>
#include <linelet/io/point_stream.h>

#include "usable_records.h"

namespace linelet::fragments {

namespace fs = std::filesystem;

namespace {

void
put(const PieceRecord& record, bool core, Fragment& fragment)
{
  fragment.points.emplace_back(record.x, record.y, record.z);
  fragment.classes.push_back(record.number_of_class);
  fragment.returns.push_back(record.number_of_returns);
  fragment.places.push_back(record.place);
  fragment.core.push_back(core);
}

} // namespace

std::size_t
Fragment::owned() const
{
  return static_cast<std::size_t>(std::count(core.begin(), core.end(), true));
}

Pieces::Pieces(const Plan& plan,
               std::string folder,
               io::ReadOptions options,
               io::ClassFilter classes)
    : plan_(plan),
      reach_(plan.reach()),
      folder_(std::move(folder)),
      options_(std::move(options)),
      classes_(std::move(classes)),
      ledger_(folder_, plan.fingerprint())
{
  options_.shift = plan.shift;
}

std::string
Pieces::path(std::size_t fragment, std::size_t input) const
{
  char name[64];
  std::snprintf(name, sizeof(name), "%06zu/%06zu.bin", fragment, input);
  return (fs::path(folder_) / "pieces" / name).string();
}

/** Where an input keeps the points that fragment \a number may have; empty if it has no
 * octree. */
Pieces::Ranges
Pieces::octreeRanges(std::size_t input, std::size_t number) const
{
  // The places in the octree hold only where nothing is left out.
  if (!options_.bounds.empty() || !options_.bounds_3d.empty() ||
      options_.resolution > 0 || options_.lenient)
    return {};
  const Area box = plan_.tiling.box(number);
  return io::copcRanges(plan_.inputs[input].path,
                        {box.low[0] - reach_,
                         box.low[1] - reach_,
                         box.high[0] + reach_,
                         box.high[1] + reach_});
}

/** \return number of points added */
std::size_t
Pieces::appendOfOctree(std::size_t input,
                       const std::vector<io::PointRange>& ranges,
                       Fragment& fragment,
                       ProgressMonitor* monitor) const
{
  const PlannedInput& planned = plan_.inputs[input];
  const std::size_t before = fragment.points.size();
  io::PointStream stream(planned.path, options_, block_size, nullptr, monitor);
  io::Cloud cloud;
  for (const io::PointRange& range : ranges) {
    std::size_t first = range.first;
    for (stream.seek(first, first + range.count); stream.next(cloud);
         first += cloud.points.size()) {
      forEachRecord(plan_,
                    planned,
                    classes_,
                    cloud,
                    first,
                    [&](const PieceRecord& record, const Point& world) {
                      bool near = false;
                      plan_.tiling.forEachNear(
                          world.x(), world.y(), reach_, [&](std::size_t number) {
                            near = near || number == fragment.number;
                          });
                      if (near)
                        put(record,
                            plan_.tiling.owner(world.x(), world.y()) == fragment.number,
                            fragment);
                    });
      throwIfCanceled(monitor);
    }
  }
  return fragment.points.size() - before;
}

void
Pieces::append(const Section& section, Fragment& fragment) const
{
  const std::string name = path(fragment.number, section.input);
  readPiece(name, [&](const PieceRecord& record) {
    const Point world = Point(record.x, record.y, record.z) + plan_.shift;
    put(record, plan_.tiling.owner(world.x(), world.y()) == fragment.number, fragment);
  });
  if (fragment.points.size() != section.first + section.count)
    throw io::FileError(name + ": cannot be read; check its disk");
}

void
Pieces::refuseIfDone(std::size_t fragment) const
{
  if (ledger_.done(Ledger::task, fragment))
    throw io::FileError("fragment " + std::to_string(fragment) +
                        " was done by another worker in the meantime");
}

std::vector<Pieces::Share>
Pieces::sharesOf(std::size_t number, ProgressMonitor* monitor) const
{
  std::vector<Share> shares;
  for (const std::size_t input : plan_.inputsOf(number)) {
    Share share{input, octreeRanges(input, number), 0};
    if (share.octree)
      for (const io::PointRange& range : *share.octree)
        share.points += range.count;
    else
      share.points = require(input, number, monitor);
    shares.push_back(std::move(share));
  }
  return shares;
}

std::uint64_t
Pieces::points(std::size_t number, ProgressMonitor* monitor) const
{
  std::uint64_t all = 0;
  for (const Share& share : sharesOf(number, monitor))
    all += share.points;
  return all;
}

Fragment
Pieces::load(std::size_t number, ProgressMonitor* monitor) const
{
  Fragment fragment;
  fragment.number = number;
  const std::vector<Share> shares = sharesOf(number, monitor);
  std::uint64_t all = 0;
  for (const Share& share : shares)
    all += share.points;
  fragment.points.reserve(all);
  fragment.classes.reserve(all);
  fragment.returns.reserve(all);
  fragment.places.reserve(all);
  fragment.core.reserve(all);
  for (const Share& share : shares) {
    Section section{share.input, fragment.points.size(), share.points};
    if (share.octree)
      section.count = appendOfOctree(share.input, *share.octree, fragment, monitor);
    else if (section.count > 0)
      append(section, fragment);
    if (section.count > 0)
      fragment.sections.push_back(section);
  }
  // Cutting an input again skips fragments that are done: empty, but not an error.
  refuseIfDone(number);
  return fragment;
}

void
Pieces::remove(std::size_t number) const
{
  std::error_code ignored;
  fs::remove_all(fs::path(path(number, 0)).parent_path(), ignored);
}

} // namespace linelet::fragments
