// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "binary_table.h"

#include <algorithm>
#include <array>
#include <utility>

#include "coordinate_form.h"

namespace linelet::io {

namespace {

class BinaryTable {
public:
  BinaryTable(const Target& target, const Cloud& cloud, std::vector<FileColumn> outputs)
      : target_(target), cloud_(cloud), outputs_(std::move(outputs))
  {
    for (const FileColumn& output : outputs_)
      row_bytes_ += sizeOf(output.type);
  }

  void
  write(OutputFile& file) const
  {
    std::string rows;
    for (std::size_t first = 0; first < cloud_.points.size(); first += block_points) {
      const std::size_t count = std::min(block_points, cloud_.points.size() - first);
      rows.resize(count * row_bytes_);
      char* at = rows.data();
      for (const FileColumn& output : outputs_) {
        fill(output, at, first, count);
        at += sizeOf(output.type);
      }
      file.write(rows);
      target_.advance(count);
    }
  }

private:
  void
  fill(const FileColumn& output, char* at, std::size_t first, std::size_t count) const
  {
    withType(output.type, [&](auto zero) {
      using T = decltype(zero);
      if (output.column == nullptr) {
        for (std::size_t i = 0; i < count; ++i, at += row_bytes_)
          store(at,
                static_cast<T>(cloud_.shift[output.axis] +
                               cloud_.points[first + i][output.axis]));
        return;
      }
      std::visit(
          [&](const auto& values) {
            for (std::size_t i = 0; i < count; ++i, at += row_bytes_)
              store(at, nearest<T>(values[first + i]));
          },
          output.column->values);
    });
  }

  const Target& target_;
  const Cloud& cloud_;
  std::vector<FileColumn> outputs_;
  std::size_t row_bytes_ = 0;
};

} // namespace

WordNames::WordNames()
{
  for (const char* name : {"x", "y", "z"})
    names_.take(name);
}

std::string
WordNames::take(const std::string& asked)
{
  return names_.take(wordName(asked));
}

std::vector<FileColumn>
coordinateColumns(const Target& target, const Cloud& cloud, bool warn_pcl)
{
  const bool floats = formOf(cloud).fits_float;
  if (!floats && warn_pcl)
    target.warn(
        "x, y and z are written with 8 bytes, as 4 cannot hold them; PCL's point "
        "types do not read such fields (linelet convert --shifted writes what they "
        "do)");
  const ValueType type = floats ? ValueType::Float32 : ValueType::Float64;
  return {{"x", type, nullptr, 0}, {"y", type, nullptr, 1}, {"z", type, nullptr, 2}};
}

std::vector<Column>
colorColumns(const Cloud& cloud)
{
  std::vector<Column> columns;
  if (auto colors = byteColors(cloud))
    for (std::size_t i = 0; i < 3; ++i)
      columns.push_back(
          {std::array<const char*, 3>{"red", "green", "blue"}[i], (*colors)[i], {}});
  return columns;
}

std::string
oneLine(std::string text)
{
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

void
writeBinaryRows(OutputFile& file,
                const Target& target,
                const Cloud& cloud,
                const std::vector<FileColumn>& columns)
{
  BinaryTable(target, cloud, columns).write(file);
}

} // namespace linelet::io
