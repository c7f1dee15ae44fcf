// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace linelet::view {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

template <class Record>
struct Member {
  const char* name;
  float Record::*value;
};

using T = PointDistributionTensor;
using S = MultiScaleShape;

constexpr std::array<Member<T>, 6> tensor_members = {{{"linearity", &T::linearity},
                                                      {"planarity", &T::planarity},
                                                      {"sphericity", &T::sphericity},
                                                      {"lambda1", &T::lambda1},
                                                      {"lambda2", &T::lambda2},
                                                      {"lambda3", &T::lambda3}}};

constexpr std::array<Member<S>, 8> shape_members = {
    {{"linearity", &S::linearity},
     {"planarity", &S::planarity},
     {"sphericity", &S::sphericity},
     {"optimal_radius", &S::optimal_radius},
     {"blend", &S::blend},
     {"linearity_sum", &S::linearity_sum},
     {"linearity_max", &S::linearity_max},
     {"min_sphericity", &S::min_sphericity}}};

/** \brief The values of \a name, without \a prefix, in \a records; none if it is not
 * one of their fields. */
template <class Record, std::size_t N>
bool
take(const std::string& name,
     const std::string& prefix,
     const std::array<Member<Record>, N>& members,
     const std::vector<Record>& records,
     std::vector<float>& values)
{
  for (const Member<Record>& member : members)
    if (name == prefix + member.name) {
      for (const Record& record : records)
        values.push_back(record.*member.value);
      return true;
    }
  return false;
}

bool
hasAll(const io::Cloud& cloud, std::initializer_list<const char*> names)
{
  return std::all_of(
      names.begin(), names.end(), [&](const char* name) { return cloud.find(name); });
}

} // namespace

std::vector<std::string>
Model::fields() const
{
  std::vector<std::string> names;
  const io::Cloud& cloud = scene_->cloud;
  if (cloud.points.empty())
    return names;
  names.emplace_back("height");
  if (results_.shapes != nullptr)
    names.emplace_back("multiscale.shape");
  if (results_.tensors != nullptr)
    names.emplace_back("tensor.shape");
  if (hasAll(cloud, {"linearity", "planarity", "sphericity"}))
    names.emplace_back("shape");
  if (hasAll(cloud, {"red", "green", "blue"}))
    names.emplace_back("rgb");
  if (lines() != nullptr)
    for (const char* name : {"powerlines.class", "powerlines.wire", "powerlines.span"})
      names.emplace_back(name);
  for (const io::Column& column : cloud.columns)
    names.push_back(column.name);
  if (results_.shapes != nullptr)
    for (const auto& member : shape_members)
      names.push_back(std::string("multiscale.") + member.name);
  if (results_.tensors != nullptr)
    for (const auto& member : tensor_members)
      names.push_back(std::string("tensor.") + member.name);
  if (lines() != nullptr)
    names.emplace_back("powerlines.wire_distance");
  return names;
}

std::vector<float>
Model::values(const std::string& field) const
{
  std::vector<float> values;
  const io::Cloud& cloud = scene_->cloud;
  const std::size_t n = cloud.points.size();
  values.reserve(n);
  if (field == "height") {
    for (const Point& p : cloud.points)
      values.push_back(static_cast<float>(p.z() + cloud.shift.z()));
    return values;
  }
  if (results_.shapes != nullptr &&
      take(field, "multiscale.", shape_members, results_.shapes->shapes, values))
    return values;
  if (results_.tensors != nullptr &&
      take(field, "tensor.", tensor_members, *results_.tensors, values))
    return values;
  if (const auto* network = lines(); network != nullptr) {
    const auto all = [&](const auto& of) {
      for (std::size_t i = 0; i < n; ++i)
        values.push_back(i < of.size() ? static_cast<float>(of[i]) : nan);
      return values;
    };
    if (field == "powerlines.class")
      return all(network->classes);
    if (field == "powerlines.wire")
      return all(network->wire_id);
    if (field == "powerlines.span")
      return all(network->span_id);
    if (field == "powerlines.wire_distance")
      return all(network->wire_distance);
  }
  const io::Column* column = cloud.find(field);
  if (column == nullptr)
    throw std::invalid_argument("there is no field '" + field +
                                "'; it may have to be computed first");
  for (std::size_t i = 0; i < n; ++i)
    values.push_back(static_cast<float>(io::valueAt(*column, i)));
  return values;
}

Coloring
Model::coloring(const std::string& field) const
{
  const auto shape = [&](const std::string& prefix) {
    return colorsByShape(values(prefix + "linearity"),
                         values(prefix + "planarity"),
                         values(prefix + "sphericity"),
                         field);
  };
  if (field == "shape")
    return shape("");
  if (field == "multiscale.shape" || field == "tensor.shape")
    return shape(field.substr(0, field.find('.') + 1));
  if (field == "rgb")
    return colorsAsGiven(values("red"), values("green"), values("blue"));
  if (field == "classification" || field == "powerlines.class")
    return colorsByClass(values(field), field);
  for (const char* number :
       {"powerlines.wire", "powerlines.span", "wire_id", "span_id"})
    if (field == number)
      return colorsByNumber(values(field), field);
  return colorsByValue(values(field), field);
}

} // namespace linelet::view
