// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/cloud.h>

#include <array>
#include <stdexcept>
#include <utility>

namespace linelet::io {

const Column*
Cloud::find(std::string_view name) const
{
  for (const Column& column : columns)
    if (column.name == name)
      return &column;
  return nullptr;
}

Column*
Cloud::find(std::string_view name)
{
  return const_cast<Column*>(std::as_const(*this).find(name));
}

void
Cloud::set(Column column)
{
  if (size(column.values) != points.size())
    throw std::invalid_argument("attribute '" + column.name + "' has " +
                                std::to_string(size(column.values)) + " values for " +
                                std::to_string(points.size()) + " points");
  if (Column* present = find(column.name))
    *present = std::move(column);
  else
    columns.push_back(std::move(column));
}

double
valueAt(const Column& column, std::size_t i)
{
  return std::visit([i](const auto& values) { return static_cast<double>(values[i]); },
                    column.values);
}

std::size_t
size(const Values& values)
{
  return std::visit([](const auto& list) { return list.size(); }, values);
}

std::string_view
typeName(const Values& values)
{
  static constexpr std::array<std::string_view, 10> names = {"int8",
                                                             "uint8",
                                                             "int16",
                                                             "uint16",
                                                             "int32",
                                                             "uint32",
                                                             "int64",
                                                             "uint64",
                                                             "float32",
                                                             "float64"};
  return names[values.index()];
}

} // namespace linelet::io
