// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <cstring>

#include "io/readers.h"
#include "las_header.h"

namespace linelet::io {

namespace {

/** Records of a block of points. */
struct Block {
  const char* records;
  std::size_t stride;
  std::size_t first, count;
};

void
readField(const LasField& field, const Block& block, Column& column)
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
readExtra(
    const LasExtra& extra, std::size_t c, const char* at, Block block, Column& column)
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

class Reader {
public:
  explicit Reader(const Source& source)
      : source_(source), origin_(std::make_shared<LasOrigin>())
  {
    header_ = readLasHeader(source, *origin_);
    findExtras();
    makeColumns();
  }

  Cloud
  read()
  {
    cloud_.points.resize(header_.count);
    chooseCorner();
    for (std::size_t first = 0; first < header_.count; first += block_points) {
      const Block block = blockAt(first);
      readCoordinates(block);
      const auto& fields = lasFields(origin_->format);
      for (std::size_t i = 0; i < fields.size(); ++i)
        readField(fields[i], block, cloud_.columns[i]);
      readExtras(block);
      source_.advance(block.count);
    }
    keepRaw();
    cloud_.format = "LAS 1." + std::to_string(header_.minor) + ", point format " +
                    std::to_string(origin_->format);
    std::string problem;
    cloud_.wkt = origin_->wkt = lasReferenceSystem(*origin_, problem);
    if (!problem.empty())
      source_.warn(problem);
    cloud_.las = std::move(origin_);
    return std::move(cloud_);
  }

private:
  Block
  blockAt(std::size_t first) const
  {
    return {source_.bytes.data() + header_.points_at + first * header_.record_length,
            header_.record_length,
            first,
            std::min(block_points, header_.count - first)};
  }

  void
  findExtras()
  {
    std::string text;
    for (const auto* records : {&origin_->records, &origin_->extended})
      for (const LasRecord& record : *records)
        if (record.is("LASF_Spec", 4))
          text += record.data;
    bool complete = true;
    origin_->extras = parseLasExtras(
        text, header_.record_length - lasRecordLength(origin_->format), complete);
    if (!complete)
      source_.warn("the extra bytes record describes more than the point records hold; "
                   "bytes it does not place are kept unread");
    inexact_.assign(origin_->extras.size(), false);
  }

  void
  makeColumns()
  {
    UniqueNames names;
    for (const LasField& field : lasFields(origin_->format)) {
      const ValueType type = field.isAngleStep() ? ValueType::Float32 : field.type;
      cloud_.columns.push_back(
          {names.take(std::string(field.name)), makeValues(type, header_.count), {}});
    }
    for (LasExtra& extra : origin_->extras) {
      const std::string_view text(&extra.descriptor[160], 32);
      for (std::size_t c = 0; c < extra.columns.size(); ++c) {
        std::string& name = extra.columns[c];
        name = names.take(name.empty() ? "extra" : name);
        const ValueType type = extra.scaled[c] ? ValueType::Float64 : extra.type;
        cloud_.columns.push_back({name,
                                  makeValues(type, header_.count),
                                  cleanName(text.substr(0, text.find('\0')))});
      }
    }
  }

  /** Puts the shift on a whole number of units near the first point. */
  void
  chooseCorner()
  {
    LasGrid& grid = origin_->grid;
    for (std::size_t axis = 0; axis < 3 && header_.count > 0; ++axis) {
      const auto a = static_cast<int>(axis);
      const auto first =
          load<std::int32_t>(source_.bytes.data() + header_.points_at + 4 * axis);
      const double whole = std::round(
          (std::floor(first * grid.scale[a] + grid.offset[a]) - grid.offset[a]) /
          grid.scale[a]);
      const bool near = std::abs(whole - first) < 0x1p31;
      grid.corner[axis] = near ? static_cast<std::int64_t>(whole) : first;
    }
    cloud_.shift = origin_->shift = grid.shift();
  }

  void
  readCoordinates(const Block& block)
  {
    const LasGrid& grid = origin_->grid;
    const char* at = block.records;
    for (std::size_t i = 0; i < block.count; ++i, at += block.stride)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int64_t steps =
            load<std::int32_t>(at + 4 * axis) - grid.corner[axis];
        cloud_.points[block.first + i][static_cast<int>(axis)] =
            static_cast<double>(steps) * grid.scale[static_cast<int>(axis)];
      }
  }

  void
  readExtras(const Block& block)
  {
    const char* at = block.records + lasRecordLength(origin_->format);
    std::size_t column = lasFields(origin_->format).size();
    for (std::size_t e = 0; e < origin_->extras.size(); ++e) {
      const LasExtra& extra = origin_->extras[e];
      for (std::size_t c = 0; c < extra.columns.size(); ++c)
        if (!readExtra(extra, c, at, block, cloud_.columns[column++]))
          inexact_[e] = true;
      at += extra.bytes;
    }
  }

  /** Copies the bytes that the columns do not tell. */
  void
  keepRaw()
  {
    std::size_t place = header_.points_at + lasRecordLength(origin_->format);
    for (std::size_t e = 0; e < origin_->extras.size(); ++e) {
      LasExtra& extra = origin_->extras[e];
      if (extra.columns.empty() || inexact_[e])
        for (std::size_t i = 0; i < header_.count; ++i)
          extra.raw +=
              source_.bytes.substr(place + i * header_.record_length, extra.bytes);
      place += extra.bytes;
    }
  }

  const Source& source_;
  std::shared_ptr<LasOrigin> origin_;
  LasHeader header_;
  Cloud cloud_;
  std::vector<bool> inexact_;
};

} // namespace

Cloud
readLas(const Source& source)
{
  return Reader(source).read();
}

} // namespace linelet::io
