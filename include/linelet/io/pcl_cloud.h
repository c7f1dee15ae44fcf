// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <linelet/io/cloud.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

namespace detail {

/** \brief Calls f(name of the column, access to the member) for every attribute that
 * the point type P has in common with Cloud, except colors. */
template <class P, class F>
void
forEachAttribute(F f)
{
  if constexpr (pcl::traits::has_intensity<P>::value)
    f(
        "intensity", [](auto& point) -> auto& { return point.intensity; });
  if constexpr (pcl::traits::has_normal<P>::value) {
    f(
        "normal_x", [](auto& point) -> auto& { return point.normal_x; });
    f(
        "normal_y", [](auto& point) -> auto& { return point.normal_y; });
    f(
        "normal_z", [](auto& point) -> auto& { return point.normal_z; });
  }
  if constexpr (pcl::traits::has_curvature<P>::value)
    f(
        "curvature", [](auto& point) -> auto& { return point.curvature; });
}

/** \brief Divisor that reduces a channel of \a column to 8 bits. */
inline double
colorDivisor(const Column& column)
{
  double largest = 0;
  for (std::size_t i = 0; i < size(column.values); ++i)
    largest = std::max(largest, valueAt(column, i));
  return largest > 255 ? 256 : 1; // LAS stores 8 bit colors in the upper half of 16
}

} // namespace detail

/** \brief The points of \a cloud, relative to its shift, as a PCL cloud: x, y, z, and
 * intensity, colors and normals where both have them. Missing values stay at P's
 * defaults. */
template <class P>
pcl::PointCloud<P>
toPcl(const Cloud& cloud)
{
  pcl::PointCloud<P> out;
  out.resize(cloud.points.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i].getVector3fMap() = cloud.points[i].cast<float>();
    out.is_dense = out.is_dense && cloud.points[i].allFinite();
  }
  detail::forEachAttribute<P>([&](const char* name, auto access) {
    const Column* column = cloud.find(name);
    for (std::size_t i = 0; column != nullptr && i < out.size(); ++i)
      access(out[i]) = static_cast<float>(valueAt(*column, i));
  });
  if constexpr (pcl::traits::has_color<P>::value) {
    const Column* channels[] = {
        cloud.find("red"), cloud.find("green"), cloud.find("blue")};
    if (channels[0] == nullptr || channels[1] == nullptr || channels[2] == nullptr)
      return out;
    double divisor = 1;
    for (const Column* channel : channels)
      divisor = std::max(divisor, detail::colorDivisor(*channel));
    const auto byte = [&](int channel, std::size_t i) {
      return static_cast<std::uint8_t>(valueAt(*channels[channel], i) / divisor);
    };
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i].r = byte(0, i);
      out[i].g = byte(1, i);
      out[i].b = byte(2, i);
    }
  }
  return out;
}

/** \brief A cloud of the points of \a in, which are relative to \a shift, with the
 * attributes named at \ref toPcl. */
template <class P>
Cloud
fromPcl(const pcl::PointCloud<P>& in, const Point& shift = Point::Zero())
{
  Cloud cloud;
  cloud.shift = shift;
  for (const P& point : in)
    cloud.points.push_back(point.getVector3fMap().template cast<double>());
  detail::forEachAttribute<P>([&](const char* name, auto access) {
    std::vector<float> values;
    for (const P& point : in)
      values.push_back(access(point));
    cloud.set({name, std::move(values), {}});
  });
  if constexpr (pcl::traits::has_color<P>::value) {
    std::vector<std::uint8_t> red, green, blue;
    for (const P& point : in) {
      red.push_back(point.r);
      green.push_back(point.g);
      blue.push_back(point.b);
    }
    cloud.set({"red", std::move(red), {}});
    cloud.set({"green", std::move(green), {}});
    cloud.set({"blue", std::move(blue), {}});
  }
  return cloud;
}

} // namespace io
} // namespace linelet
