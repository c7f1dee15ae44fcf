// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "crop.h"

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "io/las/las_format.h"

namespace linelet::io {

void
crop(Cloud& cloud, const Window& window)
{
  if (!window.limits())
    return;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    if (window.contains(cloud.shift + cloud.points[i]))
      kept.push_back(i);
  if (kept.size() == cloud.points.size())
    return;
  const auto choose = [&kept](auto& values) {
    for (std::size_t k = 0; k < kept.size(); ++k)
      values[k] = values[kept[k]];
    values.resize(kept.size());
  };
  choose(cloud.points);
  for (Column& column : cloud.columns)
    std::visit(choose, column.values);
  if (cloud.las == nullptr)
    return;
  auto las = std::make_shared<LasOrigin>(*cloud.las);
  for (LasExtra& extra : las->extras) {
    std::string raw;
    for (std::size_t k = 0; k < kept.size() && !extra.raw.empty(); ++k)
      raw.append(extra.raw, kept[k] * extra.bytes, extra.bytes);
    extra.raw = std::move(raw);
  }
  cloud.las = std::move(las);
}

} // namespace linelet::io
