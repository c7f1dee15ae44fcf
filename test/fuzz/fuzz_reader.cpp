// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// libFuzzer harness of one reader, LINELET_READER, and, if defined, of the writer
// LINELET_WRITER that gets its result; with LINELET_WINDOW only a part is read, for
// COPC by its index. Whatever the bytes, the reader returns a consistent cloud or
// throws FileError.

#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <unordered_set>

#include "io/hdf5/cloud_reader.h"
#include "io/hdf5/whole_files.h"
#include "io/las/las_reader.h"
#include "io/las/las_writer.h"
#include "io/nrrd/nrrd_reader.h"
#include "io/pcd/pcd_reader.h"
#include "io/pcd/pcd_writer.h"
#include "io/ply/ply_reader.h"
#include "io/ply/ply_writer.h"
#include "io/text/obj_vertices.h"
#include "io/text/text_reader.h"
#include "io/text/text_writer.h"

using namespace linelet::io;

namespace {

void
check(const Cloud& cloud)
{
  std::unordered_set<std::string_view> names;
  for (const Column& column : cloud.columns)
    if (column.name.empty() || size(column.values) != cloud.points.size() ||
        !names.insert(column.name).second)
      std::abort();
  if (!cloud.shift.allFinite())
    std::abort();
}

/** False if the bytes are rejected. */
bool
tryReading(std::string_view bytes, bool lenient)
{
  std::vector<std::string> warnings;
  Source source{{"input", &warnings, nullptr}, bytes, {lenient}};
#ifdef LINELET_WINDOW
  // The western half of a COPC file, level by level.
  source.options.bounds = {-1e7, -1e7, 5e5, 1e7};
  source.options.resolution = 1;
#endif
  try {
    const Cloud cloud = LINELET_READER(source);
    check(cloud);
#ifdef LINELET_WRITER
    LINELET_WRITER({"/dev/null", &warnings, nullptr}, cloud);
#endif
    return true;
  }
  catch (const FileError& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos)
      std::abort(); // the message is one line
    return false;
  }
}

} // namespace

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t length)
{
  const std::string_view bytes(reinterpret_cast<const char*>(data), length);
  if (!tryReading(bytes, false))
    tryReading(bytes, true);
  return 0;
}
