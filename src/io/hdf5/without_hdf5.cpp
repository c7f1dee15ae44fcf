// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/file_error.h>
#include <linelet/io/hdf5_file.h>

#include "cloud_reader.h"
#include "vtk_hdf.h"
#include "whole_files.h"

namespace linelet::io {

namespace {

[[noreturn]] void
refuse(const std::string& path)
{
  throw FileError(path + ": this linelet was built without HDF5; build it where "
                         "libhdf5-dev is installed, or use another format");
}

} // namespace

struct Hdf5CloudWriter::File {};

bool
hasHdf5()
{
  return false;
}

Hdf5CloudWriter::Hdf5CloudWriter(const std::string& path, const Cloud&)
{
  refuse(path);
}

Hdf5CloudWriter::~Hdf5CloudWriter() = default;

void
Hdf5CloudWriter::append(const Cloud&)
{
}

void
Hdf5CloudWriter::append(const Cloud&, std::size_t, std::size_t)
{
}

void
Hdf5CloudWriter::add(const CurveNetwork&, const Point&)
{
}

void
Hdf5CloudWriter::commit()
{
}

std::vector<Hdf5Fragment>
hdf5Fragments(const std::string& path)
{
  refuse(path);
}

Cloud
readHdf5Points(const std::string& path,
               std::size_t,
               std::size_t,
               std::vector<std::string>*)
{
  refuse(path);
}

void
writeHdf5(const std::string& path, const Cloud&, const CurveNetwork&, ProgressMonitor*)
{
  refuse(path);
}

void
writeHdf5Curves(const std::string& path,
                const CurveNetwork&,
                const Point&,
                const std::string&)
{
  refuse(path);
}

CurveNetwork
readHdf5Curves(const std::string& path, std::string*)
{
  refuse(path);
}

Cloud
readHdf5(const Source& source)
{
  refuse(source.name);
}

void
writeVtkHdf(const Target& target, const Cloud&)
{
  refuse(target.name);
}

void
writeHdf5(const Target& target, const Cloud&)
{
  refuse(target.name);
}

} // namespace linelet::io
