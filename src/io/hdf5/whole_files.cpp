// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <string>

#include <linelet/io/file_error.h>
#include <linelet/io/hdf5_file.h>

#include "curve_grid.h"
#include "io/staged_file.h"
#include "io/writers.h"
#include "layout.h"

namespace linelet::io {

using namespace hdf5;

namespace {

/// Points of a fragment of a cloud that is in memory as a whole: few enough to be
/// skipped by their box, many enough to compress well.
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
  const Session session;
  try {
    StagedFile staged(path);
    if (staged.direct())
      throw FileError(path +
                      ": HDF5 is written to files only, not to devices or pipes");
    Handle file = createFile(staged.place());
    setAttribute(createGroup(file, time_slice), "Time", std::vector<double>{0});
    writeCurveGrid(file, network, shift, wkt);
    check(H5Fflush(file.id(), H5F_SCOPE_GLOBAL), "write it");
    if (!file.reset())
      throw Error("cannot write it");
    staged.publish();
  }
  catch (const Error& error) {
    throw FileError(path + ": " + error.what() +
                    "; check that the folder exists, may be written and has room");
  }
}

} // namespace linelet::io
