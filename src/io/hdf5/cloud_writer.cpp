// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <optional>

#include <linelet/io/file_error.h>
#include <linelet/io/hdf5_file.h>

#include "curve_grid.h"
#include "layout.h"
#include "point_grid.h"
#include "staged_hdf5.h"

namespace linelet::io {

using namespace hdf5;

struct Hdf5CloudWriter::File {
  File(const std::string& file_path, const Cloud& like)
      : path(file_path), staged(file_path)
  {
    Handle slice = createGroup(staged.file(), time_slice);
    setAttribute(slice, "Time", std::vector<double>{0});
    if (!like.points.empty() || !like.columns.empty() || like.las != nullptr)
      points.emplace(staged.file(), like);
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

  void
  commit()
  {
    points.reset();
    staged.publish();
  }

  std::string path;
  StagedHdf5 staged;
  std::optional<PointGrid> points;
};

bool
hasHdf5()
{
  return true;
}

Hdf5CloudWriter::Hdf5CloudWriter(const std::string& path, const Cloud& like)
{
  writing(path, [&] { file_ = std::make_unique<File>(path, like); });
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
  writing(file_->path, [&] { file_->append(cloud, first, count); });
}

void
Hdf5CloudWriter::add(const CurveNetwork& network, const Point& shift)
{
  writing(file_->path,
          [&] { writeCurveGrid(file_->staged.file(), network, shift, {}); });
}

void
Hdf5CloudWriter::commit()
{
  writing(file_->path, [&] { file_->commit(); });
}

} // namespace linelet::io
