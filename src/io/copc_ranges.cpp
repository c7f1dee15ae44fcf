// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/copc_ranges.h>

#include <algorithm>

#include "io/copc/copc_index.h"
#include "io/las/las_header.h"

#include "files.h"
#include "source.h"
#include "window.h"

namespace linelet::io {

namespace {

/** \brief Whether two lists contain the same chunks, so that an index into one is valid
 * in the other. */
bool
areSame(const std::vector<laz::Chunk>& some, const std::vector<laz::Chunk>& others)
{
  return std::equal(some.begin(),
                    some.end(),
                    others.begin(),
                    others.end(),
                    [](const laz::Chunk& a, const laz::Chunk& b) {
                      return a.at == b.at && a.first == b.first && a.count == b.count;
                    });
}

} // namespace

std::optional<std::vector<PointRange>>
copcRanges(const std::string& path, const std::array<double, 4>& bounds)
{
  if (endingOf(path) != ".laz")
    return {};
  const MappedFile file(path);
  Source source;
  source.name = path;
  source.bytes = file.bytes();
  LasOrigin origin;
  const LasHeader header = readLasHeader(source, origin);
  const auto info =
      std::find_if(origin.records.begin(),
                   origin.records.end(),
                   [](const LasRecord& record) { return record.is("copc", 1); });
  if (info == origin.records.end() || !origin.compression)
    return {};
  try {
    const CopcIndex index(source.bytes, info->data);
    Window window = windowOf({});
    const std::vector<laz::Chunk> all = index.chunks(window, 0);
    if (!areSame(all,
                 laz::readChunkTable(
                     source.bytes, header.points_at, header.count, *origin.compression)
                     .chunks))
      return {};
    window.low.head<2>() << bounds[0], bounds[1];
    window.high.head<2>() << bounds[2], bounds[3];
    std::vector<PointRange> ranges;
    auto place = all.begin();
    for (const laz::Chunk& chunk : index.chunks(window, 0)) {
      while (place->at != chunk.at)
        ++place;
      if (!ranges.empty() && ranges.back().first + ranges.back().count == place->first)
        ranges.back().count += place->count;
      else
        ranges.push_back({place->first, place->count});
    }
    return ranges;
  }
  catch (const laz::Error&) {
    return {};
  }
}

} // namespace linelet::io
