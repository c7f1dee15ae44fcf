// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/merge.h>

#include <algorithm>
#include <type_traits>

namespace linelet::io {

namespace {

/** Values of both, in their common type, or as doubles if the types differ. */
Values
joined(const Column& first, const Column& second)
{
  return std::visit(
      [](const auto& a, const auto& b) -> Values {
        if constexpr (std::is_same_v<decltype(a), decltype(b)>) {
          auto both = a;
          both.insert(both.end(), b.begin(), b.end());
          return both;
        }
        else {
          std::vector<double> both(a.begin(), a.end());
          both.insert(both.end(), b.begin(), b.end());
          return both;
        }
      },
      first.values,
      second.values);
}

} // namespace

void
append(Cloud& cloud, const Cloud& more, std::vector<std::string>* warnings)
{
  const Point step = more.shift - cloud.shift;
  cloud.points.reserve(cloud.points.size() + more.points.size());
  for (const Point& point : more.points)
    cloud.points.push_back(point + step);
  std::vector<Column> columns;
  std::string lost;
  for (const Column& column : cloud.columns)
    if (const Column* same = more.find(column.name))
      columns.push_back({column.name, joined(column, *same), column.description});
    else
      lost += " " + column.name;
  for (const Column& column : more.columns)
    if (cloud.find(column.name) == nullptr)
      lost += " " + column.name;
  if (!lost.empty() && warnings != nullptr)
    warnings->push_back("attributes that not all inputs have are left out:" + lost);
  cloud.columns = std::move(columns);
}

} // namespace linelet::io
