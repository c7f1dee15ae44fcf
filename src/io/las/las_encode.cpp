// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "las_encode.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <linelet/support/threads.h>

#include "io/columns.h"
#include "io/coordinate_form.h"

namespace linelet::io {

bool
fitsLasField(const LasField& field, const Column& column)
{
  const double largest_angle = 32767 * las_angle_step;
  return std::visit(
      [&](const auto& values) {
        using Value = typename std::decay_t<decltype(values)>::value_type;
        if (field.bits == 0 && !field.isAngleStep() && typeOf(column) == field.type)
          return true;
        if constexpr (std::is_same_v<Value, std::uint8_t>)
          if (field.bits != 0) {
            std::uint8_t all = 0;
            for (const std::uint8_t value : values)
              all |= value;
            return all < (1U << field.bits);
          }
        return std::all_of(values.begin(), values.end(), [&](auto value) {
          if (field.isAngleStep())
            return std::abs(static_cast<double>(value)) <= largest_angle;
          if (field.bits != 0)
            return representable<std::uint8_t>(value) &&
                   static_cast<unsigned>(value) < (1U << field.bits);
          return withType(field.type, [value](auto zero) {
            return representable<decltype(zero)>(value);
          });
        });
      },
      column.values);
}

void
writeLasField(const LasField& field,
              const Column* column,
              double factor,
              const LasBlock& block)
{
  char* at = block.records + field.byte;
  if (column == nullptr) {
    // By default, a return is the only one.
    if (field.name == "return_number" || field.name == "number_of_returns")
      for (std::size_t i = 0; i < block.count; ++i, at += block.stride)
        *at = static_cast<char>(*at | (1 << field.shift));
    return;
  }
  std::visit(
      [&](const auto& values) {
        const auto* value = values.data() + block.first;
        if (field.bits != 0) {
          const unsigned mask = (1U << field.bits) - 1U;
          for (std::size_t i = 0; i < block.count; ++i, at += block.stride)
            *at = static_cast<char>(
                static_cast<unsigned char>(*at) |
                (std::min<unsigned>(nearest<std::uint8_t>(value[i]), mask)
                 << field.shift));
        }
        else if (field.isAngleStep())
          for (std::size_t i = 0; i < block.count; ++i, at += block.stride)
            store(
                at,
                nearest<std::int16_t>(static_cast<double>(value[i]) / las_angle_step));
        else
          withType(field.type, [&](auto zero) {
            using T = decltype(zero);
            for (std::size_t i = 0; i < block.count; ++i, at += block.stride)
              store(at,
                    factor == 1 ? nearest<T>(value[i])
                                : nearest<T>(static_cast<double>(value[i]) * factor));
          });
      },
      column->values);
}

namespace {

template <class T>
void
writeComponent(const LasExtra& extra,
               std::size_t c,
               const char* raw,
               const Column& column,
               char* at,
               const LasBlock& block)
{
  std::visit(
      [&](const auto& values) {
        const auto* value = values.data() + block.first;
        for (std::size_t i = 0; i < block.count; ++i, at += block.stride) {
          if (!extra.scaled[c]) {
            store(at, nearest<T>(value[i]));
            continue;
          }
          const auto wanted = static_cast<double>(value[i]);
          if (raw != nullptr) {
            const char* old = raw + (block.first + i) * extra.bytes + c * sizeof(T);
            const double said =
                static_cast<double>(load<T>(old)) * extra.scale[c] + extra.offset[c];
            if (std::memcmp(&said, &wanted, sizeof said) == 0) {
              std::memcpy(at, old, sizeof(T));
              continue;
            }
          }
          store(at, nearest<T>((wanted - extra.offset[c]) / extra.scale[c]));
        }
      },
      column.values);
}

} // namespace

void
writeLasExtra(const LasExtra& extra,
              std::size_t at,
              const Cloud& cloud,
              const LasBlock& block)
{
  const bool known = extra.raw.size() == extra.bytes * cloud.points.size();
  const char* raw = known ? extra.raw.data() : nullptr;
  if (extra.columns.empty() && known)
    for (std::size_t i = 0; i < block.count; ++i)
      std::memcpy(block.records + i * block.stride + at,
                  raw + (block.first + i) * extra.bytes,
                  extra.bytes);
  for (std::size_t c = 0; c < extra.columns.size(); ++c)
    if (const Column* column = cloud.find(extra.columns[c]))
      withType(extra.type, [&](auto zero) {
        using T = decltype(zero);
        char* place = block.records + at + c * sizeof(T);
        writeComponent<T>(extra, c, raw, *column, place, block);
      });
}

LasSteps::LasSteps(const Cloud& cloud, unsigned threads)
    : points_(cloud.points), shift_(cloud.shift)
{
  if (cloud.las != nullptr) {
    grid_ = cloud.las->grid;
    native_ = cloud.las->shift == cloud.shift;
    if (holds(threads))
      return;
    replaced_ = true;
  }
  native_ = false;
  choose(cloud);
}

double
LasSteps::steps(const Point& point, int axis) const
{
  const double scale = grid_.scale[axis];
  if (native_)
    return std::round(point[axis] / scale) +
           static_cast<double>(grid_.corner[static_cast<std::size_t>(axis)]);
  return std::round((shift_[axis] - grid_.offset[axis] + point[axis]) / scale);
}

bool
LasSteps::holds(unsigned threads) const
{
  bool all = true;
#pragma omp parallel for schedule(static) reduction(&& : all)                         \
    num_threads(threadCount(threads))
  for (std::size_t i = 0; i < points_.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      all = all && representable<std::int32_t>(steps(points_[i], axis));
  return all;
}

void
LasSteps::choose(const Cloud& cloud)
{
  grid_ = LasGrid{};
  if (points_.empty())
    return;
  Point low = points_.front(), high = points_.front();
  for (const Point& point : points_) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const int decimals = formOf(cloud).decimals;
  constexpr double reach = 0x1p32 + 0.5; // steps
  for (int axis = 0; axis < 3; ++axis) {
    grid_.offset[axis] = std::ceil(shift_[axis] + (low[axis] + high[axis]) / 2);
    const double extent = high[axis] - low[axis] + 1;
    // Millimeters or finer, as far as the coordinates have decimals and the integers
    // suffice.
    double divisor = 1e3;
    for (int finer = 3; finer < (decimals < 0 ? 9 : decimals); ++finer)
      if (extent * divisor * 10 < reach)
        divisor *= 10;
    while (extent * divisor > reach)
      divisor /= 10;
    grid_.scale[axis] = 1 / divisor;
  }
}

std::array<std::int32_t, 3>
LasSteps::operator()(std::size_t i) const
{
  std::array<std::int32_t, 3> at;
  for (int axis = 0; axis < 3; ++axis)
    at[static_cast<std::size_t>(axis)] = nearest<std::int32_t>(steps(points_[i], axis));
  return at;
}

} // namespace linelet::io
