// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "las_extra.h"

#include <algorithm>
#include <cmath>

#include "io/source.h"

namespace linelet::io {

namespace {

// The LAS number of each type is its index here plus one.
constexpr std::array<ValueType, 10> las_types = {ValueType::UInt8,
                                                 ValueType::Int8,
                                                 ValueType::UInt16,
                                                 ValueType::Int16,
                                                 ValueType::UInt32,
                                                 ValueType::Int32,
                                                 ValueType::UInt64,
                                                 ValueType::Int64,
                                                 ValueType::Float32,
                                                 ValueType::Float64};

// Places in a descriptor.
constexpr std::size_t type_at = 2, options_at = 3, name_at = 4, scale_at = 112,
                      offset_at = 136, description_at = 160, text_size = 32;
constexpr unsigned scale_bit = 8, offset_bit = 16;

std::string
textAt(std::string_view descriptor, std::size_t at)
{
  const std::string_view text = descriptor.substr(at, text_size);
  return cleanName(text.substr(0, text.find('\0')));
}

LasExtra
parse(std::string_view descriptor)
{
  LasExtra extra;
  extra.descriptor = descriptor;
  const auto type = static_cast<unsigned char>(descriptor[type_at]);
  const auto options = static_cast<unsigned char>(descriptor[options_at]);
  if (type == 0 || type > 30) {
    // Undocumented bytes; the options field holds their number.
    extra.bytes = type == 0 ? options : 0;
    return extra;
  }
  extra.type = las_types[(type - 1U) % 10U];
  const std::size_t components = 1U + (type - 1U) / 10U;
  extra.bytes = components * sizeOf(extra.type);
  const std::string name = textAt(descriptor, name_at);
  for (std::size_t i = 0; i < components; ++i) {
    extra.columns.push_back(components == 1 ? name : name + "_" + std::to_string(i));
    const double scale = load<double>(&descriptor[scale_at + 8 * i]);
    const double offset = load<double>(&descriptor[offset_at + 8 * i]);
    if ((options & scale_bit) != 0 && std::isnormal(scale))
      extra.scale[i] = scale;
    if ((options & offset_bit) != 0 && std::isfinite(offset))
      extra.offset[i] = offset;
    extra.scaled[i] = extra.scale[i] != 1 || extra.offset[i] != 0;
  }
  return extra;
}

} // namespace

LasExtra
opaqueLasExtra(std::size_t bytes)
{
  LasExtra extra;
  extra.descriptor.assign(las_descriptor_size, '\0');
  extra.descriptor[options_at] = static_cast<char>(bytes);
  std::string_view("undocumented").copy(&extra.descriptor[name_at], text_size);
  extra.bytes = bytes;
  return extra;
}

std::vector<LasExtra>
parseLasExtras(std::string_view text, std::size_t bytes, bool& complete)
{
  std::vector<LasExtra> extras;
  complete = text.size() % las_descriptor_size == 0;
  for (; text.size() >= las_descriptor_size; text.remove_prefix(las_descriptor_size)) {
    LasExtra extra = parse(text.substr(0, las_descriptor_size));
    if (extra.bytes == 0 || extra.bytes > bytes) {
      complete = false; // without its length, whatever follows cannot be located
      break;
    }
    bytes -= extra.bytes;
    extras.push_back(std::move(extra));
  }
  for (; bytes > 0; bytes -= extras.back().bytes)
    extras.push_back(opaqueLasExtra(std::min<std::size_t>(bytes, 255)));
  return extras;
}

LasExtra
describeLasExtra(const Column& column)
{
  LasExtra extra;
  extra.type = typeOf(column);
  extra.bytes = sizeOf(extra.type);
  extra.columns = {column.name};
  extra.descriptor.assign(las_descriptor_size, '\0');
  const auto* place = std::find(las_types.begin(), las_types.end(), extra.type);
  extra.descriptor[type_at] = static_cast<char>(place - las_types.begin() + 1);
  column.name.copy(&extra.descriptor[name_at], text_size);
  column.description.copy(&extra.descriptor[description_at], text_size);
  return extra;
}

} // namespace linelet::io
