// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/io/output_file.h>

#include "columns.h"
#include "file_work.h"

namespace linelet::io {

/** \brief A column of a file: an attribute, a coordinate or a packed color. */
struct FileColumn {
  std::string name;
  ValueType type;
  const Column* column = nullptr; ///< null: coordinate \a axis
  int axis = 0;
};

/** \brief x, y and z in world coordinates, with 4 bytes where that is exact.
 *
 * \param warn_pcl whether to warn otherwise, as PCL then cannot read them */
std::vector<FileColumn>
coordinateColumns(const Target& target, const Cloud& cloud, bool warn_pcl);

/** \brief The cloud's 8-bit colors as red, green and blue; empty if it has none or
 * wider ones. */
std::vector<Column>
colorColumns(const Cloud& cloud);

/** \brief Unique names without spaces; x, y and z are taken. */
class WordNames {
public:
  WordNames();

  std::string
  take(const std::string& asked);

private:
  UniqueNames names_;
};

/** \brief \a text without line breaks, for a line of a header. */
std::string
oneLine(std::string text);

/** \brief Writes a row of little-endian values per point, without gaps. */
void
writeBinaryRows(OutputFile& file,
                const Target& target,
                const Cloud& cloud,
                const std::vector<FileColumn>& columns);

} // namespace linelet::io
