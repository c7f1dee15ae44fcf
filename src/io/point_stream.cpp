// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/point_stream.h>

#include <algorithm>
#include <utility>

#include "files.h"
#include "las/las_reader.h"
#include "reference_systems.h"
#include "source.h"

namespace linelet::io {

PointStream::PointStream(std::string path,
                         ReadOptions options,
                         std::size_t block,
                         std::vector<std::string>* warnings,
                         ProgressMonitor* monitor)
    : path_(std::move(path)),
      options_(std::move(options)),
      block_(block),
      warnings_(warnings),
      monitor_(monitor)
{
}

void
PointStream::seek(std::size_t first, std::size_t behind)
{
  first_ = first;
  behind_ = behind;
  over_ = false;
}

bool
PointStream::next(Cloud& cloud)
{
  if (over_)
    return false;
  const std::string ending = endingOf(path_);
  if (ending == ".las" || ending == ".laz")
    return nextOfLas(cloud);
  cloud = readCloud(path_, options_, warnings_, monitor_);
  over_ = true;
  return true;
}

bool
PointStream::nextOfLas(Cloud& cloud)
{
  // Mapped for each block, so that only one block at a time is resident.
  const MappedFile file(path_, monitor_);
  std::size_t passed = 0;
  Source source;
  source.name = path_;
  source.warnings = begun_ ? nullptr : warnings_;
  source.monitor = monitor_;
  source.bytes = file.bytes();
  source.options = options_;
  source.first = first_;
  source.behind = std::min(first_ + block_, behind_);
  source.passed = &passed;
  Cloud block = readLas(source);
  over_ = passed == 0;
  if (over_ && begun_)
    return false;
  if (!options_.crs.empty())
    block.wkt = declaredReference(options_.crs);
  if (!options_.shift && !block.points.empty())
    options_.shift = block.shift; // one for all blocks
  first_ += passed;
  begun_ = true;
  cloud = std::move(block);
  return true;
}

} // namespace linelet::io
