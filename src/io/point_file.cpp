// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/point_file.h>

#include <array>
#include <filesystem>
#include <system_error>

#include <linelet/io/output_check.h>

#include "files.h"
#include "readers.h"
#include "shift_file.h"
#include "writers.h"

namespace linelet::io {

namespace {

struct Format {
  const char* ending;
  Cloud (*read)(const Source& source);
  void (*write)(const Target& target, const Cloud& cloud);
};

constexpr std::array<Format, 8> formats = {
    {{".las", readLas, writeLas},
     {".pcd", readPcd, writePcd},
     {".ply", readPly, writePly},
     {".xyz", readText, writeText},
     {".txt", readText, writeText},
     {".csv", readText, writeText},
     {".xy", readText, nullptr},
     {".obj", readObjVertices, writeObjVertices}}};

const Format&
formatOf(const std::string& path)
{
  const std::string ending = endingOf(path);
  for (const Format& format : formats)
    if (ending == format.ending)
      return format;
  if (ending == ".laz")
    throw FileError(
        path + ": LAZ is compressed LAS, which linelet neither reads nor writes; "
               "decompress it first, for example with `laszip -i in.laz -o out.las` "
               "or `pdal translate in.laz out.las`");
  throw FileError(path + ": the ending '" + ending +
                  "' names no format; use .las, .pcd, .ply, .xyz, .txt, .csv or .obj");
}

const Format&
writtenFormatOf(const std::string& path)
{
  const Format& format = formatOf(path);
  if (format.write == nullptr)
    throw FileError(path + ": .xy files are read only; use .xyz");
  return format;
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
  const MappedFile file(path, monitor);
  if (monitor != nullptr)
    monitor->begin("reading", 0);
  Cloud cloud = format.read({{path, warnings, monitor}, file.bytes(), options});
  if (format.read != readLas)
    cloud.shift += readShift(path);
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
  if (options.shifted && format.write == writeLas)
    throw FileError(path + ": LAS carries a shift of its own; leave out --shifted");
  if (monitor != nullptr)
    monitor->begin("writing", cloud.points.size());
  const Target target = {path, warnings, monitor};
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
