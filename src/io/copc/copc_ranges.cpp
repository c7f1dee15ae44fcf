// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/copc_ranges.h>

#include <algorithm>
#include <limits>

#include "copc_index.h"
#include "io/files.h"
#include "io/las/las_header.h"
#include "io/source.h"

namespace linelet::io {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/** \brief Whether two lists name the same chunks, so that places in the one are places
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
    const std::vector<laz::Chunk> all =
        index.chunks({Point::Constant(-unlimited), Point::Constant(unlimited)}, 0);
    if (!areSame(all,
                 laz::readChunkTable(
                     source.bytes, header.points_at, header.count, *origin.compression)
                     .chunks))
      return {};
    std::vector<PointRange> ranges;
    auto place = all.begin();
    for (const laz::Chunk& chunk :
         index.chunks({Point(bounds[0], bounds[1], -unlimited),
                       Point(bounds[2], bounds[3], unlimited)},
                      0)) {
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
