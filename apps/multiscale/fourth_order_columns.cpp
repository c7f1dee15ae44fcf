// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fourth_order_columns.h"

#include <string>
#include <utility>
#include <vector>

#include <linelet/features/fourth_order.h>

namespace linelet::apps {

namespace {

ScaleWeight
weightOf(FourthOrderOption option)
{
  switch (option) {
  case FourthOrderOption::Planarity:
    return ScaleWeight::Planarity;
  case FourthOrderOption::Sphericity:
    return ScaleWeight::Sphericity;
  case FourthOrderOption::Uniform:
    return ScaleWeight::Uniform;
  case FourthOrderOption::None:
  case FourthOrderOption::Linearity:
    break;
  }
  return ScaleWeight::Linearity;
}

} // namespace

void
addFourthOrder(io::Cloud& cloud,
               const Points& points,
               const MultiScaleSettings& settings,
               FourthOrderOption weight,
               ProgressMonitor* monitor)
{
  const std::vector<FourthOrderTensor> tensors =
      fourthOrderTensors(points, points, settings, weightOf(weight), monitor);
  constexpr std::array<const char*, 6> rows = {"xx", "yy", "zz", "yz", "xz", "xy"};
  std::vector<std::array<double, 21>> components;
  std::vector<Eigen::Matrix3d> majors;
  for (const FourthOrderTensor& tensor : tensors) {
    components.push_back(tensor.components());
    majors.push_back(tensor.eigenTensors().major());
  }
  const auto add = [&](const std::string& name, const char* description, auto value) {
    std::vector<float> values;
    for (std::size_t i = 0; i < tensors.size(); ++i)
      values.push_back(static_cast<float>(value(i)));
    cloud.set({name, std::move(values), description});
  };
  std::size_t place = 0;
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t column = row; column < rows.size(); ++column, ++place)
      add(std::string("t4_") + rows[row] + '_' + rows[column],
          "fourth-order tensor, Mandel",
          [&](std::size_t i) { return components[i][place]; });
  constexpr std::array<std::pair<int, int>, 6> entries = {
      {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};
  for (const auto& [i, j] : entries)
    add(std::string("major_") + "xyz"[i] + "xyz"[j],
        "major eigentensor",
        [&, row = i, column = j](std::size_t k) { return majors[k](row, column); });
}

} // namespace linelet::apps
