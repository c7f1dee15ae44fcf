// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "wanted_attributes.h"

#include <algorithm>

namespace linelet::io {

bool
isWanted(const ReadOptions& options, std::string_view name)
{
  const auto& names = options.attributes;
  return !names || std::find(names->begin(), names->end(), name) != names->end();
}

void
keepWanted(Cloud& cloud, const ReadOptions& options)
{
  auto& columns = cloud.columns;
  columns.erase(std::remove_if(columns.begin(),
                               columns.end(),
                               [&](const Column& column) {
                                 return !isWanted(options, column.name);
                               }),
                columns.end());
}

} // namespace linelet::io
