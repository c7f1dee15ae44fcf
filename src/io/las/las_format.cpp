// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "las_format.h"

#include <algorithm>
#include <stdexcept>

#include "io/source.h"

namespace linelet::io {

namespace {

using T = ValueType;

std::vector<LasField>
makeFields(int format)
{
  std::vector<LasField> fields = {{"intensity", T::UInt16, 12}};
  const auto add = [&fields](std::initializer_list<LasField> more) {
    fields.insert(fields.end(), more);
  };
  if (format < 6)
    add({{"return_number", T::UInt8, 14, 0, 3},
         {"number_of_returns", T::UInt8, 14, 3, 3},
         {"scan_direction", T::UInt8, 14, 6, 1},
         {"edge_of_flight_line", T::UInt8, 14, 7, 1},
         {"classification", T::UInt8, 15, 0, 5},
         {"synthetic", T::UInt8, 15, 5, 1},
         {"key_point", T::UInt8, 15, 6, 1},
         {"withheld", T::UInt8, 15, 7, 1},
         {"scan_angle", T::Int8, 16},
         {"user_data", T::UInt8, 17},
         {"point_source_id", T::UInt16, 18}});
  else
    add({{"return_number", T::UInt8, 14, 0, 4},
         {"number_of_returns", T::UInt8, 14, 4, 4},
         {"synthetic", T::UInt8, 15, 0, 1},
         {"key_point", T::UInt8, 15, 1, 1},
         {"withheld", T::UInt8, 15, 2, 1},
         {"overlap", T::UInt8, 15, 3, 1},
         {"scanner_channel", T::UInt8, 15, 4, 2},
         {"scan_direction", T::UInt8, 15, 6, 1},
         {"edge_of_flight_line", T::UInt8, 15, 7, 1},
         {"classification", T::UInt8, 16},
         {"user_data", T::UInt8, 17},
         {"scan_angle", T::Int16, 18},
         {"point_source_id", T::UInt16, 20}});

  std::size_t end = format < 6 ? 20 : 22;
  const auto append = [&](std::string_view name, ValueType type) {
    fields.push_back({name, type, end});
    end += sizeOf(type);
  };
  if (format != 0 && format != 2)
    append("gps_time", T::Float64);
  const bool color = format == 2 || format == 3 || format == 5 || format == 7 ||
                     format == 8 || format == 10;
  if (color)
    for (const char* name : {"red", "green", "blue"})
      append(name, T::UInt16);
  if (format == 8 || format == 10)
    append("nir", T::UInt16);
  if (hasWaveform(format)) {
    append("waveform_descriptor", T::UInt8);
    append("waveform_offset", T::UInt64);
    append("waveform_size", T::UInt32);
    for (const char* name :
         {"waveform_location", "waveform_dx", "waveform_dy", "waveform_dz"})
      append(name, T::Float32);
  }
  return fields;
}

} // namespace

bool
hasWaveform(int format)
{
  return format == 4 || format == 5 || format == 9 || format == 10;
}

std::size_t
lasRecordLength(int format)
{
  static constexpr std::array<std::size_t, 11> lengths = {
      20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
  return lengths.at(static_cast<std::size_t>(format));
}

const std::vector<LasField>&
lasFields(int format)
{
  static const std::vector<std::vector<LasField>> all = [] {
    std::vector<std::vector<LasField>> fields;
    for (int i = 0; i <= 10; ++i)
      fields.push_back(makeFields(i));
    return fields;
  }();
  return all.at(static_cast<std::size_t>(format));
}

bool
isLasName(std::string_view name)
{
  const auto& fields = lasFields(8);
  return std::any_of(fields.begin(), fields.end(), [name](const LasField& field) {
    return field.name == name;
  });
}

std::string_view
LasRecord::user() const
{
  const std::string_view text = std::string_view(head).substr(2, 16);
  return text.substr(0, text.find('\0'));
}

unsigned
LasRecord::number() const
{
  return load<std::uint16_t>(head.data() + 18);
}

LasRecord
makeLasRecord(std::string_view user,
              unsigned number,
              std::string_view description,
              std::string data)
{
  if (data.size() > 65535)
    throw std::length_error("a LAS record of " + std::to_string(data.size()) +
                            " bytes");
  LasRecord record{std::string(54, '\0'), std::move(data)};
  user.copy(&record.head[2], 16);
  store(&record.head[18], static_cast<std::uint16_t>(number));
  store(&record.head[20], static_cast<std::uint16_t>(record.data.size()));
  description.copy(&record.head[22], 31);
  return record;
}

Point
LasGrid::shift() const
{
  Point shift;
  for (int axis = 0; axis < 3; ++axis)
    shift[axis] =
        static_cast<double>(corner[static_cast<std::size_t>(axis)]) * scale[axis] +
        offset[axis];
  return shift;
}

} // namespace linelet::io
