// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/usable_points.h>

#include <limits>

namespace linelet::io {

UsablePoints::UsablePoints(const Cloud& cloud, std::vector<std::string>* warnings)
    : cloud_(cloud)
{
  const Column* flags = cloud.find("withheld");
  if (flags == nullptr)
    return;
  std::visit(
      [this](const auto& values) {
        for (std::size_t i = 0; i < values.size(); ++i) {
          if (values[i] == 0)
            continue;
          if (withheld_++ == 0)
            usable_ = cloud_.points;
          usable_[i].setConstant(std::numeric_limits<double>::quiet_NaN());
        }
      },
      flags->values);
  if (withheld_ > 0 && warnings != nullptr)
    warnings->push_back(std::to_string(withheld_) + " of " +
                        std::to_string(cloud.points.size()) +
                        " points are flagged as withheld and take no part");
}

} // namespace linelet::io
