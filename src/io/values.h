// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <linelet/io/cloud.h>

namespace linelet::io {

/** \brief The type of an attribute, in the order of the alternatives of Values. */
enum class ValueType : std::uint8_t {
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Int64,
  UInt64,
  Float32,
  Float64
};

/** \brief Calls \a f with a zero of the C++ type that \a type stands for. */
template <class F>
decltype(auto)
withType(ValueType type, F&& f)
{
  switch (type) {
  case ValueType::Int8:
    return f(std::int8_t{});
  case ValueType::UInt8:
    return f(std::uint8_t{});
  case ValueType::Int16:
    return f(std::int16_t{});
  case ValueType::UInt16:
    return f(std::uint16_t{});
  case ValueType::Int32:
    return f(std::int32_t{});
  case ValueType::UInt32:
    return f(std::uint32_t{});
  case ValueType::Int64:
    return f(std::int64_t{});
  case ValueType::UInt64:
    return f(std::uint64_t{});
  case ValueType::Float32:
    return f(float{});
  case ValueType::Float64:
    break;
  }
  return f(double{});
}

inline std::size_t
sizeOf(ValueType type)
{
  return withType(type, [](auto zero) { return sizeof(zero); });
}

inline ValueType
typeOf(const Column& column)
{
  return static_cast<ValueType>(column.values.index());
}

/** \brief \a count zeros of \a type. */
inline Values
makeValues(ValueType type, std::size_t count)
{
  return withType(
      type, [&](auto zero) { return Values(std::vector<decltype(zero)>(count)); });
}

/** \brief Whether \a To can hold the integer \a value without loss; floating-point
 * targets accept everything. */
template <class To, class From>
bool
representable(From value)
{
  if constexpr (std::is_floating_point_v<To>)
    return true;
  else if constexpr (std::is_floating_point_v<From>)
    // The upper limit of a 64-bit type is not a double, so compare with the power of
    // two.
    return value >= static_cast<From>(std::numeric_limits<To>::min()) &&
           value < std::ldexp(static_cast<From>(1), std::numeric_limits<To>::digits) &&
           std::trunc(value) == value;
  else if constexpr (std::is_signed_v<From> == std::is_signed_v<To>)
    return value >= std::numeric_limits<To>::min() &&
           value <= std::numeric_limits<To>::max();
  else if constexpr (std::is_signed_v<From>)
    return value >= 0 && static_cast<std::make_unsigned_t<From>>(value) <=
                             std::numeric_limits<To>::max();
  else
    return value <=
           static_cast<std::make_unsigned_t<To>>(std::numeric_limits<To>::max());
}

/** \brief The value of \a To nearest to \a value; 0 for NaN if To is an integer. */
template <class To, class From>
To
nearest(From value)
{
  if constexpr (std::is_floating_point_v<To>)
    return static_cast<To>(value);
  else if constexpr (std::is_floating_point_v<From>) {
    const From whole = std::round(value);
    if (representable<To>(whole))
      return static_cast<To>(whole);
    if (std::isnan(value))
      return To{0};
    return value < 0 ? std::numeric_limits<To>::min() : std::numeric_limits<To>::max();
  }
  else {
    if (representable<To>(value))
      return static_cast<To>(value);
    return value < From{0} ? std::numeric_limits<To>::min()
                           : std::numeric_limits<To>::max();
  }
}

} // namespace linelet::io
