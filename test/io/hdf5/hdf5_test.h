// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <linelet/io/file_error.h>
#include <linelet/io/hdf5_file.h>
#include <linelet/io/point_file.h>

#include "io/file_helpers.h"

namespace linelet::test {

using namespace linelet::io;

/** \brief A cloud with a column of every type, a tensor and a name with a slash. */
inline Cloud
example(std::size_t count, std::size_t first = 0)
{
  Cloud cloud;
  cloud.shift = Point(512000.25, 5427000.5, 200);
  cloud.wkt = "LOCAL_CS[\"somewhere\"]";
  for (std::size_t i = first; i < first + count; ++i)
    cloud.points.emplace_back(0.1 * static_cast<double>(i), std::sqrt(i), 1e-3);
  const auto fill = [&](const char* name, auto zero, const char* description = "") {
    std::vector<decltype(zero)> values;
    for (std::size_t i = first; i < first + count; ++i)
      values.push_back(static_cast<decltype(zero)>(i * 1234567 + values.size() % 3));
    cloud.set({name, std::move(values), description});
  };
  fill("i8", std::int8_t{});
  fill("classification", std::uint8_t{});
  for (const char* entry : {"xx", "xy", "xz", "yy", "yz", "zz"})
    fill(entry, float{}, "neighborhood tensor");
  fill("a/b.", std::int16_t{}, "a description with \xC3\xA4");
  fill("intensity", std::uint16_t{});
  fill("i32", std::int32_t{});
  fill("u32", std::uint32_t{});
  fill("i64", std::int64_t{});
  fill("u64", std::uint64_t{});
  fill("time", double{});
  return cloud;
}

/** \brief Equal, with NaN equal to NaN. */
inline bool
sameBits(const Values& a, const Values& b)
{
  return a.index() == b.index() &&
         std::visit(
             [&](const auto& values) {
               using V = std::decay_t<decltype(values)>;
               const V& others = std::get<V>(b);
               return values.size() == others.size() &&
                      (values.empty() ||
                       std::memcmp(values.data(),
                                   others.data(),
                                   values.size() * sizeof(typename V::value_type)) ==
                           0);
             },
             a);
}

inline void
expectEqual(const Cloud& a, const Cloud& b)
{
  EXPECT_EQ(a.shift, b.shift);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.wkt, b.wkt);
  ASSERT_EQ(a.columns.size(), b.columns.size());
  for (std::size_t i = 0; i < a.columns.size(); ++i) {
    EXPECT_EQ(a.columns[i].name, b.columns[i].name);
    EXPECT_EQ(a.columns[i].description, b.columns[i].description);
    EXPECT_TRUE(sameBits(a.columns[i].values, b.columns[i].values))
        << a.columns[i].name;
  }
}

/** \brief The points from \a first on. */
inline Cloud
part(const Cloud& cloud, std::size_t first, std::size_t count)
{
  Cloud some = cloud;
  const auto cut = [&](auto& values) {
    values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(first));
    values.resize(count);
  };
  cut(some.points);
  for (Column& column : some.columns)
    std::visit(cut, column.values);
  return some;
}

class Hdf5 : public testing::Test {
protected:
  void
  SetUp() override
  {
    if (!hasHdf5())
      GTEST_SKIP() << "built without HDF5";
  }

  Folder folder;
};

} // namespace linelet::test
