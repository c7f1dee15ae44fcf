// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "part.h"

#include <stdexcept>
#include <variant>

namespace linelet::view {

Part::Part(const Scene& scene, const std::optional<Box>& box)
{
  if (!box)
    return;
  all = false;
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    if (box->contains(scene.cloud.points[i]))
      indices.push_back(static_cast<Index>(i));
  if (indices.empty())
    throw std::invalid_argument(
        "no point lies in the preview box; move it to the cloud, or clear it");
}

io::Cloud
cloudOf(const Scene& scene, const Part& part)
{
  io::Cloud cloud;
  cloud.shift = scene.cloud.shift;
  cloud.wkt = scene.cloud.wkt;
  cloud.points = part.of(scene.cloud.points);
  for (const char* name : {"classification", "withheld"})
    if (const io::Column* column = scene.cloud.find(name))
      std::visit(
          [&](const auto& values) {
            cloud.set({name, part.of(values), ""});
          },
          column->values);
  return cloud;
}

Points
usablePoints(const Scene& scene, const Part& part, const io::ClassFilter& classes)
{
  const io::Cloud cloud = cloudOf(scene, part);
  return io::UsablePoints(cloud, nullptr, classes).points();
}

} // namespace linelet::view
