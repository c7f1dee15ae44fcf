// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <optional>

#include <linelet/io/file_error.h>
#include <linelet/io/hdf5_file.h>

#include "curve_grid.h"
#include "io/staged_file.h"
#include "layout.h"
#include "point_grid.h"

namespace linelet::io {

using namespace hdf5;

struct Hdf5CloudWriter::File {
  File(const std::string& file_path, const Cloud& like)
      : path(file_path), staged(file_path)
  {
    if (staged.direct())
      throw FileError(path +
                      ": HDF5 is written to files only, not to devices or pipes");
    file = createFile(staged.place());
    Handle slice = createGroup(file, time_slice);
    setAttribute(slice, "Time", std::vector<double>{0});
    if (!like.points.empty() || !like.columns.empty() || like.las != nullptr)
      points.emplace(file, like);
  }

  void
  append(const Cloud& cloud, std::size_t first, std::size_t count)
  {
    if (!points || !points->fits(cloud))
      throw FileError(path + ": a block of points does not have the attributes of the "
                             "others; give all of them the same");
    if (count > 0)
      points->append(cloud, first, count);
  }

  /** \brief Calls \a work; errors of HDF5 name the file. */
  template <class Work>
  void
  guarded(Work&& work)
  {
    const Session session;
    try {
      work();
    }
    catch (const Error& error) {
      throw FileError(path + ": " + error.what() +
                      "; check that there is room on the disk");
    }
  }

  void
  commit()
  {
    check(H5Fflush(file.id(), H5F_SCOPE_GLOBAL), "write it");
    points.reset();
    if (!file.reset())
      throw Error("cannot write it");
    staged.publish();
  }

  std::string path;
  StagedFile staged;
  Handle file;
  std::optional<PointGrid> points;
};

bool
hasHdf5()
{
  return true;
}

Hdf5CloudWriter::Hdf5CloudWriter(const std::string& path, const Cloud& like)
{
  const Session session;
  try {
    file_ = std::make_unique<File>(path, like);
  }
  catch (const Error& error) {
    throw FileError(path + ": " + error.what() +
                    "; check that the folder exists, may be written and has room");
  }
}

Hdf5CloudWriter::~Hdf5CloudWriter()
{
  const Session session;
  file_.reset();
}

void
Hdf5CloudWriter::append(const Cloud& block)
{
  append(block, 0, block.points.size());
}

void
Hdf5CloudWriter::append(const Cloud& cloud, std::size_t first, std::size_t count)
{
  file_->guarded([&] { file_->append(cloud, first, count); });
}

void
Hdf5CloudWriter::add(const CurveNetwork& network, const Point& shift)
{
  file_->guarded([&] { writeCurveGrid(file_->file, network, shift, {}); });
}

void
Hdf5CloudWriter::commit()
{
  file_->guarded([&] { file_->commit(); });
}

} // namespace linelet::io
