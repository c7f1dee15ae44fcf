// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "whole_files.h"

#include <algorithm>
#include <string>

#include <linelet/io/hdf5_file.h>

#include "curve_grid.h"
#include "layout.h"
#include "staged_hdf5.h"

namespace linelet::io {

using namespace hdf5;

namespace {

/// Points per fragment for a cloud that is in memory as a whole: few enough that boxes
/// help to skip, many enough to compress well.
constexpr std::size_t fragment_points = 1 << 18;

void
appendAll(Hdf5CloudWriter& writer, const Cloud& cloud, const FileWork& work)
{
  for (std::size_t first = 0; first < cloud.points.size(); first += fragment_points) {
    const std::size_t count = std::min(fragment_points, cloud.points.size() - first);
    writer.append(cloud, first, count);
    work.advance(count);
  }
}

} // namespace

void
writeHdf5(const Target& target, const Cloud& cloud)
{
  Hdf5CloudWriter writer(target.name, cloud);
  appendAll(writer, cloud, target);
  writer.commit();
}

void
writeHdf5(const std::string& path,
          const Cloud& cloud,
          const CurveNetwork& network,
          ProgressMonitor* monitor)
{
  Hdf5CloudWriter writer(path, cloud);
  appendAll(writer, cloud, {path, nullptr, monitor});
  writer.add(network, cloud.shift);
  writer.commit();
}

void
writeHdf5Curves(const std::string& path,
                const CurveNetwork& network,
                const Point& shift,
                const std::string& wkt)
{
  writing(path, [&] {
    StagedHdf5 staged(path);
    setAttribute(
        createGroup(staged.file(), time_slice), "Time", std::vector<double>{0});
    writeCurveGrid(staged.file(), network, shift, wkt);
    staged.publish();
  });
}

} // namespace linelet::io
