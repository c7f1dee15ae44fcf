// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/point_file.h>

#include <array>
#include <filesystem>
#include <system_error>

#include <linelet/io/output_check.h>
#include <linelet/io/output_file.h>

#include "crop.h"
#include "files.h"
#include "hdf5/cloud_reader.h"
#include "hdf5/vtk_hdf.h"
#include "hdf5/whole_files.h"
#include "las/las_reader.h"
#include "las/las_writer.h"
#include "nrrd/nrrd_reader.h"
#include "pcd/pcd_reader.h"
#include "pcd/pcd_writer.h"
#include "ply/ply_reader.h"
#include "ply/ply_writer.h"
#include "reference_systems.h"
#include "shift_file.h"
#include "text/obj_vertices.h"
#include "text/text_reader.h"
#include "text/text_writer.h"
#include "vector_points.h"
#include "wanted_attributes.h"
#include "window.h"

namespace linelet::io {

namespace {

struct Format {
  const char* ending;
  Cloud (*read)(const Source& source);
  void (*write)(const Target& target, const Cloud& cloud);
};

constexpr std::array<Format, 12> formats = {
    {{".las", readLas, writeLas},
     {".laz", readLas, writeLaz},
     {".pcd", readPcd, writePcd},
     {".ply", readPly, writePly},
     {".h5", readHdf5, writeHdf5},
     {".vtkhdf", nullptr, writeVtkHdf},
     {".xyz", readText, writeText},
     {".txt", readText, writeText},
     {".csv", readText, writeText},
     {".xy", readText, nullptr},
     {".obj", readObjVertices, writeObjVertices},
     {".nrrd", readNrrd, nullptr}}};

const Format&
formatOf(const std::string& path)
{
  const std::string ending = endingOf(path);
  for (const Format& format : formats)
    if (ending == format.ending)
      return format;
  if (const VectorPoints* vector = vectorPoints();
      vector != nullptr && vector->reads(path)) {
    static const Format vertices = {"", vector->read, nullptr};
    return vertices;
  }
  throw FileError(
      path + ": the ending '" + ending +
      "' names no format; use .las, .laz, .pcd, .ply, .h5, .xyz, .txt, .csv, .obj "
      "or .nrrd");
}

const Format&
writtenFormatOf(const std::string& path)
{
  const Format& format = formatOf(path);
  if (format.write == nullptr)
    throw FileError(path + ": " + endingOf(path) +
                    " is not a format for writing points; use .las, .laz, .pcd, .ply, "
                    ".h5 or .xyz");
  return format;
}

/** Gives \a cloud the reference system \a text: EPSG:n, WKT, or a file of WKT. */
void
declareReference(Cloud& cloud,
                 const std::string& path,
                 const std::string& text,
                 std::vector<std::string>* warnings)
{
  const std::string wkt = declaredReference(text);
  const auto nameOf = referenceSystems()->nameOf;
  const std::string before = nameOf(cloud.wkt);
  if (!before.empty() && before != nameOf(wkt) && warnings != nullptr)
    warnings->push_back(path + ": its reference system " + before +
                        " is overridden by --crs");
  cloud.wkt = wkt;
}

/** Changes the shift of \a cloud to \a shift. */
void
moveShift(Cloud& cloud, const Point& shift)
{
  const Point step = cloud.shift - shift;
  if (step == Point::Zero())
    return;
  for (Point& point : cloud.points)
    point += step;
  cloud.shift = shift;
}

} // namespace

void
checkCloudOutput(const std::string& path)
{
  writtenFormatOf(path);
  checkWritable(path);
}

Cloud
readCloud(const std::string& path,
          const ReadOptions& options,
          std::vector<std::string>* warnings,
          ProgressMonitor* monitor)
{
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored))
    throw FileError(path + ": is a folder; name a point file");
  const Format& format = formatOf(path);
  if (format.read == nullptr)
    throw FileError(path + ": " + endingOf(path) +
                    " files are written for ParaView and not read; read the cloud it "
                    "was made from");
  const Window window = windowOf(options);
  const MappedFile file(path, monitor);
  if (monitor != nullptr)
    monitor->begin("reading", 0);
  Source source;
  source.name = path;
  source.warnings = warnings;
  source.monitor = monitor;
  source.bytes = file.bytes();
  source.options = options;
  Cloud cloud = format.read(source);
  if (format.read != readLas) {
    cloud.shift += readShift(path);
    if (options.shift)
      moveShift(cloud, *options.shift);
    if (options.resolution > 0 && warnings != nullptr)
      warnings->push_back(path + ": " + no_copc);
    crop(cloud, window);
    keepWanted(cloud, options);
  }
  if (!options.crs.empty())
    declareReference(cloud, path, options.crs, warnings);
  return cloud;
}

void
writeCloud(const std::string& path,
           const Cloud& cloud,
           const WriteOptions& options,
           std::vector<std::string>* warnings,
           ProgressMonitor* monitor)
{
  const Format& format = writtenFormatOf(path);
  if (options.shifted && (format.read == readLas || format.read == readHdf5))
    throw FileError(path + ": " + (format.read == readLas ? "LAS" : "HDF5") +
                    " has its own shift; omit --shifted");
  if (monitor != nullptr)
    monitor->begin("writing", cloud.points.size());
  const Target target = {path, warnings, monitor, options.threads};
  if (!options.shifted) {
    format.write(target, cloud);
    writeShift(path, Point::Zero());
    return;
  }
  Cloud near = cloud;
  near.shift = Point::Zero();
  format.write(target, near);
  writeShift(path, cloud.shift);
}

} // namespace linelet::io
