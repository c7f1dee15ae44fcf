// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "given_tensors.h"

#include <array>
#include <stdexcept>

namespace linelet::apps {

const std::vector<std::string>&
tensorAttributes()
{
  static const std::vector<std::string> names = {"xx", "xy", "xz", "yy", "yz", "zz"};
  return names;
}

std::vector<SymmetricTensor>
givenTensors(const io::Cloud& cloud, const std::string& file)
{
  std::array<const io::Column*, 6> columns{};
  for (std::size_t e = 0; e < columns.size(); ++e) {
    columns[e] = cloud.find(tensorAttributes()[e]);
    if (columns[e] == nullptr)
      throw std::runtime_error(file + ": there is no attribute '" +
                               tensorAttributes()[e] +
                               "'; --tensors needs xx, xy, xz, yy, yz and zz, as "
                               "linelet tensor writes them and .nrrd has them");
  }
  std::vector<SymmetricTensor> tensors;
  tensors.reserve(cloud.points.size());
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const auto entry = [&](std::size_t e) { return io::valueAt(*columns[e], i); };
    tensors.push_back({entry(0), entry(1), entry(2), entry(3), entry(4), entry(5)});
  }
  return tensors;
}

} // namespace linelet::apps
