// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// The pass over an input that cuts it into pieces.

#include <linelet/fragments/pieces.h>

#include <filesystem>

#include <linelet/io/point_stream.h>

#include "usable_records.h"

namespace linelet::fragments {

void
Pieces::cut(std::size_t input, ProgressMonitor* monitor) const
{
  const PlannedInput& planned = plan_.inputs[input];
  const Area& area = planned.extent.area;
  std::vector<bool> wanted(plan_.tiling.boxes(), false);
  for (const std::size_t f : plan_.tiling.near(area, reach_))
    wanted[f] = !ledger_.done(Ledger::task, f);
  PieceFiles pieces([&](std::size_t fragment) { return path(fragment, input); });
  io::PointStream stream(planned.path, options_, block_size, nullptr, monitor);
  io::Cloud cloud;
  std::size_t first = 0;
  while (stream.next(cloud)) {
    forEachRecord(plan_,
                  planned,
                  classes_,
                  cloud,
                  first,
                  [&](const PieceRecord& record, const Point& world) {
                    plan_.tiling.forEachNear(
                        world.x(), world.y(), reach_, [&](std::size_t fragment) {
                          if (wanted[fragment])
                            pieces.add(fragment, record);
                        });
                  });
    first += cloud.points.size();
    pieces.flush();
    throwIfCanceled(monitor);
  }
  Ledger::Entry entry;
  entry.done = true;
  entry.points = static_cast<double>(first);
  entry.pieces = pieces.publish();
  ledger_.write(Ledger::cut, input, entry);
}

void
Pieces::cutOrTellWhyNot(std::size_t input, ProgressMonitor* monitor) const
{
  for (const bool again : {false, true})
    try {
      return cut(input, monitor);
    }
    catch (const Canceled&) {
      throw;
    }
    catch (const std::exception& error) {
      if (!again)
        continue;
      Ledger::Entry entry;
      entry.reason = error.what();
      ledger_.write(Ledger::cut, input, entry); // other fragments need not try
      throw;
    }
}

std::uint64_t
Pieces::require(std::size_t input, std::size_t fragment, ProgressMonitor* monitor) const
{
  const auto points = [&]() -> std::optional<std::uint64_t> {
    refuseIfDone(fragment);
    const auto entry = ledger_.find(Ledger::cut, input);
    if (!entry)
      return {};
    if (!entry->done)
      throw io::FileError(entry->reason);
    const auto piece = entry->pieces.find(fragment);
    if (piece == entry->pieces.end())
      return 0;
    std::error_code error;
    const auto bytes = std::filesystem::file_size(path(fragment, input), error);
    if (error || bytes != piece->second * sizeof(PieceRecord))
      return {};
    return piece->second;
  };
  if (const auto known = points())
    return *known;
  // Not cut yet, or by now without this piece.
  const WorkLock lock(ledger_.path(Ledger::cut, input));
  if (const auto known = points())
    return *known;
  cutOrTellWhyNot(input, monitor);
  if (const auto known = points())
    return *known;
  throw io::FileError(path(fragment, input) + ": cannot be read back");
}

} // namespace linelet::fragments
