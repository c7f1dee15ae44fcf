// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "las_columns.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "io/wanted_attributes.h"
#include "las_compatible.h"
#include "las_layers.h"

namespace linelet::io {

namespace {

void
readField(const LasField& field, const RecordBlock& block, Column& column)
{
  const char* at = block.records + field.byte;
  if (field.bits != 0) {
    auto* out = std::get<std::vector<std::uint8_t>>(column.values).data() + block.first;
    const unsigned mask = (1U << field.bits) - 1U;
    for (std::size_t i = 0; i < block.count; ++i, at += block.stride)
      out[i] = static_cast<std::uint8_t>(
          (static_cast<unsigned char>(*at) >> field.shift) & mask);
    return;
  }
  if (field.isAngleStep()) {
    auto* out = std::get<std::vector<float>>(column.values).data() + block.first;
    for (std::size_t i = 0; i < block.count; ++i, at += block.stride)
      out[i] = static_cast<float>(load<std::int16_t>(at) * las_angle_step);
    return;
  }
  std::visit(
      [&](auto& values) {
        using T = typename std::decay_t<decltype(values)>::value_type;
        T* out = values.data() + block.first;
        for (std::size_t i = 0; i < block.count; ++i, at += block.stride)
          out[i] = load<T>(at);
      },
      column.values);
}

/** Reads component \a c of an extra entry; false where scaling loses the raw value. */
bool
readExtra(const LasExtra& extra,
          std::size_t c,
          const char* at,
          RecordBlock block,
          Column& column)
{
  at += c * sizeOf(extra.type);
  return withType(extra.type, [&](auto zero) {
    using T = decltype(zero);
    if (!extra.scaled[c]) {
      T* out = std::get<std::vector<T>>(column.values).data() + block.first;
      for (std::size_t i = 0; i < block.count; ++i, at += block.stride)
        out[i] = load<T>(at);
      return true;
    }
    double* out = std::get<std::vector<double>>(column.values).data() + block.first;
    bool exact = true;
    for (std::size_t i = 0; i < block.count; ++i, at += block.stride) {
      const T raw = load<T>(at);
      out[i] = static_cast<double>(raw) * extra.scale[c] + extra.offset[c];
      const T back = nearest<T>((out[i] - extra.offset[c]) / extra.scale[c]);
      exact = exact && std::memcmp(&back, &raw, sizeof raw) == 0;
    }
    return exact;
  });
}

} // namespace

LasColumns::LasColumns(const Source& source,
                       const LasHeader& header,
                       LasOrigin& origin,
                       Cloud& cloud)
    : source_(source), header_(header), origin_(origin), cloud_(cloud)
{
  findExtras();
  makeColumns();
  findRaw();
}

void
LasColumns::makeRoom()
{
  for (Column& column : cloud_.columns)
    std::visit([this](auto& values) { values.resize(header_.count); }, column.values);
  for (std::size_t e = 0; e < origin_.extras.size(); ++e)
    if (keeps_raw_[e] != 0)
      origin_.extras[e].raw.resize(origin_.extras[e].bytes * header_.count);
}

void
LasColumns::read(const RecordBlock& block)
{
  for (std::size_t i = 0; i < fields_.size(); ++i)
    readField(fields_[i], block, cloud_.columns[i]);
  readExtras(block);
}

void
LasColumns::findExtras()
{
  std::string text;
  for (const auto* records : {&origin_.records, &origin_.extended})
    for (const LasRecord& record : *records)
      if (record.is("LASF_Spec", 4))
        text += record.data;
  bool complete = true;
  origin_.extras = parseLasExtras(
      text, header_.record_length - lasRecordLength(origin_.format), complete);
  if (!complete)
    source_.warn("the extra bytes record describes more than the point records hold; "
                 "bytes it does not place are kept unread");
}

bool
LasColumns::reads(std::string_view name) const
{
  return isCompatible(origin_) || isWanted(source_.options, name);
}

void
LasColumns::makeColumns()
{
  UniqueNames names;
  for (const LasField& field : lasFields(origin_.format)) {
    const ValueType type = field.isAngleStep() ? ValueType::Float32 : field.type;
    const std::string name = names.take(std::string(field.name));
    if (!reads(name))
      continue;
    fields_.push_back(field);
    layers_ |= layersOf(field);
    cloud_.columns.push_back({name, makeValues(type, 0), {}});
  }
  for (LasExtra& extra : origin_.extras) {
    const std::string_view text(&extra.descriptor[160], 32);
    for (std::size_t c = 0; c < extra.columns.size(); ++c) {
      std::string& name = extra.columns[c];
      name = names.take(name.empty() ? "extra" : name);
      extra_columns_.push_back(reads(name) ? cloud_.columns.size() : unread);
      if (!reads(name))
        continue;
      layers_ |= laz::field::extra_bytes;
      const ValueType type = extra.scaled[c] ? ValueType::Float64 : extra.type;
      cloud_.columns.push_back(
          {name, makeValues(type, 0), cleanName(text.substr(0, text.find('\0')))});
    }
  }
}

void
LasColumns::findRaw()
{
  for (const LasExtra& extra : origin_.extras) {
    inexact_.push_back(std::make_unique<std::atomic<bool>>(extra.columns.empty()));
    const bool scaled = extra.scaled[0] || extra.scaled[1] || extra.scaled[2];
    const bool whole =
        extra.columns.empty()
            ? !source_.options.attributes
            : std::all_of(extra.columns.begin(),
                          extra.columns.end(),
                          [this](const std::string& name) { return reads(name); });
    keeps_raw_.push_back(whole && (extra.columns.empty() || scaled) ? 1 : 0);
    if (keeps_raw_.back() != 0)
      layers_ |= laz::field::extra_bytes;
  }
}

void
LasColumns::readExtras(const RecordBlock& block)
{
  const char* at = block.records + lasRecordLength(origin_.format);
  std::size_t column = 0;
  for (std::size_t e = 0; e < origin_.extras.size(); ++e) {
    LasExtra& extra = origin_.extras[e];
    for (std::size_t c = 0; c < extra.columns.size(); ++c)
      if (const std::size_t to = extra_columns_[column++];
          to != unread && !readExtra(extra, c, at, block, cloud_.columns[to]))
        *inexact_[e] = true;
    for (std::size_t i = 0; i < block.count && !extra.raw.empty(); ++i)
      std::memcpy(&extra.raw[(block.first + i) * extra.bytes],
                  at + i * block.stride,
                  extra.bytes);
    at += extra.bytes;
  }
}

void
LasColumns::finish()
{
  for (std::size_t e = 0; e < origin_.extras.size(); ++e)
    if (!*inexact_[e])
      origin_.extras[e].raw.clear();
}

} // namespace linelet::io
