// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "las_reader.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>

#include <linelet/io/whole_shift.h>

#include "io/copc/copc_index.h"
#include "io/wanted_attributes.h"
#include "io/window.h"
#include "las_blocks.h"
#include "las_compatible.h"
#include "las_layers.h"
#include "las_reference.h"

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

class Reader {
public:
  explicit Reader(const Source& source)
      : source_(source),
        window_(windowOf(source.options)),
        origin_(std::make_shared<LasOrigin>()),
        header_(readLasHeader(source, *origin_)),
        blocks_(findBlocks())
  {
    blocks_.keep(source.first, source.behind);
    if (source.passed != nullptr)
      *source.passed = blocks_.points();
    if (window_.limits())
      select();
    else
      header_.count = blocks_.points();
    findExtras();
    makeColumns();
    makeRoomForRaw();
  }

  Cloud
  read()
  {
    cloud_.points.resize(header_.count);
    chooseCorner();
    if (window_.limits())
      readSelected();
    else
      blocks_.forEach(
          layers_, [this](std::size_t, const RecordBlock& block) { readBlock(block); });
    dropRaw();
    cloud_.format = formatName(header_, *origin_);
    if (const int format = restoreCompatible(cloud_, *origin_); format != 0)
      cloud_.format += ", which stands for point format " + std::to_string(format);
    keepWanted(cloud_, source_.options);
    std::string problem;
    cloud_.wkt = origin_->wkt = lasReferenceSystem(*origin_, problem);
    if (!problem.empty())
      source_.warn(problem);
    cloud_.las = std::move(origin_);
    return std::move(cloud_);
  }

private:
  /** All blocks, or those that an index selects. */
  LasBlocks
  findBlocks()
  {
    const auto info =
        std::find_if(origin_->records.begin(),
                     origin_->records.end(),
                     [](const LasRecord& record) { return record.is("copc", 1); });
    const double resolution = source_.options.resolution;
    if (info != origin_->records.end() && origin_->compression) {
      try {
        const CopcIndex index(source_.bytes, info->data);
        origin_->copc_levels = index.levels();
        if (window_.limits() || resolution > 0)
          return {source_, *origin_, header_, index.chunks(window_, resolution)};
      }
      catch (const laz::Error& error) {
        source_.warn(std::string(error.what()) + "; it is read without its index");
      }
    }
    if (resolution > 0 && origin_->copc_levels == 0)
      source_.warn(no_copc);
    return {source_, *origin_, header_};
  }

  bool
  isInWindow(const char* record) const
  {
    Point world;
    for (int axis = 0; axis < 3; ++axis)
      world[axis] = load<std::int32_t>(record + 4 * axis) * origin_->grid.scale[axis] +
                    origin_->grid.offset[axis];
    return window_.contains(world);
  }

  /** Keeps the records in the window, block by block. */
  void
  select()
  {
    selected_.resize(blocks_.size());
    const auto anyInWindow = [this](const RecordBlock& block) {
      for (std::size_t i = 0; i < block.count; ++i)
        if (isInWindow(block.record(i)))
          return true;
      return false;
    };
    blocks_.forEach(
        layers_,
        [this](std::size_t number, const RecordBlock& block) {
          for (std::size_t i = 0; i < block.count; ++i)
            if (isInWindow(block.record(i)))
              selected_[number].append(block.record(i), block.stride);
        },
        anyInWindow);
    header_.count = 0;
    for (const std::string& records : selected_)
      header_.count += records.size() / header_.record_length;
  }

  void
  readSelected()
  {
    std::size_t first = 0;
    for (std::string& records : selected_) {
      const std::size_t count = records.size() / header_.record_length;
      readBlock({records.data(), header_.record_length, first, count});
      first += count;
      records = {};
    }
  }

  /** The first record of the file, or null. */
  const char*
  firstRecord() const
  {
    if (!window_.limits())
      return blocks_.firstRecord();
    for (const std::string& records : selected_)
      if (!records.empty())
        return records.data();
    return nullptr;
  }

  void
  readBlock(const RecordBlock& block)
  {
    readCoordinates(block);
    for (std::size_t i = 0; i < fields_.size(); ++i)
      readField(fields_[i], block, cloud_.columns[i]);
    readExtras(block);
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
  }

  /** Whether the column \a name is read. What a file in compatibility mode stands for
   * is made of columns of other names. */
  bool
  reads(std::string_view name) const
  {
    return isCompatible(*origin_) || isWanted(source_.options, name);
  }

  void
  makeColumns()
  {
    UniqueNames names;
    for (const LasField& field : lasFields(origin_->format)) {
      const ValueType type = field.isAngleStep() ? ValueType::Float32 : field.type;
      const std::string name = names.take(std::string(field.name));
      if (!reads(name))
        continue;
      fields_.push_back(field);
      layers_ |= layersOf(field);
      cloud_.columns.push_back({name, makeValues(type, header_.count), {}});
    }
    for (LasExtra& extra : origin_->extras) {
      const std::string_view text(&extra.descriptor[160], 32);
      for (std::size_t c = 0; c < extra.columns.size(); ++c) {
        std::string& name = extra.columns[c];
        name = names.take(name.empty() ? "extra" : name);
        extra_columns_.push_back(reads(name) ? cloud_.columns.size() : unread);
        if (!reads(name))
          continue;
        layers_ |= laz::field::extra_bytes;
        const ValueType type = extra.scaled[c] ? ValueType::Float64 : extra.type;
        cloud_.columns.push_back({name,
                                  makeValues(type, header_.count),
                                  cleanName(text.substr(0, text.find('\0')))});
      }
    }
  }

  /** For what the columns may not tell of the extra bytes, where these are read whole.
   */
  void
  makeRoomForRaw()
  {
    for (LasExtra& extra : origin_->extras) {
      inexact_.push_back(std::make_unique<std::atomic<bool>>(extra.columns.empty()));
      const bool scaled = extra.scaled[0] || extra.scaled[1] || extra.scaled[2];
      const bool whole =
          extra.columns.empty()
              ? !source_.options.attributes
              : std::all_of(extra.columns.begin(),
                            extra.columns.end(),
                            [this](const std::string& name) { return reads(name); });
      if (!whole || !(extra.columns.empty() || scaled))
        continue;
      extra.raw.resize(extra.bytes * header_.count);
      layers_ |= laz::field::extra_bytes;
    }
  }

  /** Puts the shift near the box of the points, so that a part of a cloud can have that
   * of the whole; near the first point where the header tells no box; or near the one
   * asked for. */
  void
  chooseCorner()
  {
    LasGrid& grid = origin_->grid;
    for (std::size_t axis = 0; axis < 3 && header_.count > 0; ++axis) {
      const auto a = static_cast<int>(axis);
      const auto first = load<std::int32_t>(firstRecord() + 4 * axis);
      const double wanted = wantedShift(first * grid.scale[a] + grid.offset[a], a);
      const double whole = std::round((wanted - grid.offset[a]) / grid.scale[a]);
      const bool near = std::abs(whole - first) < 0x1p31;
      grid.corner[axis] = near ? static_cast<std::int64_t>(whole) : first;
    }
    cloud_.shift = origin_->shift = grid.shift();
  }

  double
  wantedShift(double first, int axis) const
  {
    if (source_.options.shift)
      return (*source_.options.shift)[axis];
    const auto [low, high] = lasBounds(*origin_, axis);
    const bool sane = first >= low - 1 && first <= high + 1;
    return sane ? wholeShift(low, high) : std::floor(first);
  }

  void
  readCoordinates(const RecordBlock& block)
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
  readExtras(const RecordBlock& block)
  {
    const char* at = block.records + lasRecordLength(origin_->format);
    std::size_t column = 0;
    for (std::size_t e = 0; e < origin_->extras.size(); ++e) {
      LasExtra& extra = origin_->extras[e];
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

  /** Drops the raw bytes that the columns represent. */
  void
  dropRaw()
  {
    for (std::size_t e = 0; e < origin_->extras.size(); ++e)
      if (!*inexact_[e])
        origin_->extras[e].raw.clear();
  }

  const Source& source_;
  Window window_;
  std::shared_ptr<LasOrigin> origin_;
  LasHeader header_;
  LasBlocks blocks_;
  std::vector<std::string> selected_; ///< records in the window, by block
  Cloud cloud_;
  std::vector<LasField> fields_;           ///< of the first columns
  laz::Fields layers_ = 0;                 ///< of all columns
  std::vector<std::size_t> extra_columns_; ///< of the components of the extra entries
  static constexpr std::size_t unread = static_cast<std::size_t>(-1);
  std::vector<std::unique_ptr<std::atomic<bool>>> inexact_; // one an extra entry
};

} // namespace

Cloud
readLas(const Source& source)
{
  return Reader(source).read();
}

} // namespace linelet::io
