// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/file_summary.h>

#include "io/las/las_header.h"
#include "io/las/las_reference.h"

#include "files.h"
#include "reference_systems.h"

namespace linelet::io {

namespace {

FileSummary
summaryOfLas(const Source& source)
{
  LasOrigin origin;
  const LasHeader header = readLasHeader(source, origin);
  FileSummary summary;
  summary.format = formatName(header, origin);
  summary.points = header.count;
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low, high] = lasBounds(origin, axis);
    summary.low[axis] = low;
    summary.high[axis] = high;
  }
  std::string problem;
  summary.wkt = lasReferenceSystem(origin, problem);
  return summary;
}

FileSummary
summaryOfCloud(const Cloud& cloud)
{
  FileSummary summary;
  summary.format = cloud.format;
  summary.points = cloud.points.size();
  summary.wkt = cloud.wkt;
  bool first = true;
  for (const Point& point : cloud.points) {
    if (!point.allFinite())
      continue;
    const Point world = cloud.shift + point;
    summary.low = first ? world : Point(summary.low.cwiseMin(world));
    summary.high = first ? world : Point(summary.high.cwiseMax(world));
    first = false;
  }
  return summary;
}

} // namespace

FileSummary
summaryOf(const std::string& path,
          const ReadOptions& options,
          std::vector<std::string>* warnings)
{
  const std::string ending = endingOf(path);
  FileSummary summary;
  if (ending == ".las" || ending == ".laz") {
    const MappedFile file(path, nullptr);
    Source source;
    source.name = path;
    source.warnings = warnings;
    source.bytes = file.bytes();
    source.options = options;
    summary = summaryOfLas(source);
    if (!options.crs.empty())
      summary.wkt = declaredReference(options.crs);
  }
  else {
    ReadOptions all;
    all.lenient = options.lenient;
    all.crs = options.crs;
    all.attributes.emplace(); // none
    summary = summaryOfCloud(readCloud(path, all, warnings));
  }
  summary.path = path;
  return summary;
}

} // namespace linelet::io
