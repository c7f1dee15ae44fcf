// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "las_writer.h"

#include <algorithm>

#include <linelet/io/output_file.h>

#include "io/source.h"
#include "las_front.h"
#include "las_records.h"
#include "laz_points.h"

namespace linelet::io {

namespace {

void
write(const Target& target, const Cloud& cloud, bool compress)
{
  LasFront front(target, cloud, compress);
  LasTotals totals;
  front.count(totals);
  const std::size_t count = cloud.points.size();
  std::optional<LazPoints> points;
  std::uint64_t bytes = count * front.recordLength();
  if (front.compression()) {
    points.emplace(*front.compression(), target.threads);
    points->encode(count, [&](std::size_t first, std::size_t number) {
      target.advance(number);
      return front.makeRecords(first, number);
    });
    bytes = points->size();
  }
  const std::string before = front.before(totals, bytes);
  OutputFile file(target.name);
  file.write(before);
  if (points)
    points->write(file, before.size());
  else
    forEachRecords(
        front, count, target, [&](const std::string& records) { file.write(records); });
  file.write(front.behind());
  file.commit();
}

/** The points with coordinates: LAS cannot express missing ones. */
Cloud
withoutHoles(const Cloud& cloud)
{
  Cloud kept;
  kept.shift = cloud.shift;
  kept.wkt = cloud.wkt;
  kept.las = cloud.las;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    if (cloud.points[i].allFinite())
      places.push_back(i);
  for (std::size_t i : places)
    kept.points.push_back(cloud.points[i]);
  for (const Column& column : cloud.columns)
    std::visit(
        [&](const auto& values) {
          std::decay_t<decltype(values)> chosen;
          for (std::size_t i : places)
            chosen.push_back(values[i]);
          kept.columns.push_back({column.name, std::move(chosen), column.description});
        },
        column.values);
  return kept;
}

void
writeAs(const Target& target, const Cloud& cloud, bool compress)
{
  const auto holes =
      std::count_if(cloud.points.begin(), cloud.points.end(), [](const Point& point) {
        return !point.allFinite();
      });
  if (holes == 0)
    return write(target, cloud, compress);
  target.warn(std::to_string(holes) +
              " points without coordinates are left out: LAS cannot hold them");
  write(target, withoutHoles(cloud), compress);
}

} // namespace

void
writeLas(const Target& target, const Cloud& cloud)
{
  writeAs(target, cloud, false);
}

void
writeLaz(const Target& target, const Cloud& cloud)
{
  writeAs(target, cloud, true);
}

} // namespace linelet::io
