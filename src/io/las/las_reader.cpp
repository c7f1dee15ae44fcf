// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "las_reader.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <linelet/io/whole_shift.h>

#include "io/copc/copc_index.h"
#include "io/wanted_attributes.h"
#include "io/window.h"
#include "las_blocks.h"
#include "las_columns.h"
#include "las_compatible.h"
#include "las_reference.h"

namespace linelet::io {

namespace {

class Reader {
public:
  explicit Reader(const Source& source)
      : source_(source),
        window_(windowOf(source.options)),
        origin_(std::make_shared<LasOrigin>()),
        header_(readLasHeader(source, *origin_)),
        blocks_(findBlocks()),
        columns_(source, header_, *origin_, cloud_)
  {
    blocks_.keep(source.first, source.behind);
    if (source.passed != nullptr)
      *source.passed = blocks_.points();
    if (window_.limits())
      select();
    else
      header_.count = blocks_.points();
    columns_.makeRoom();
  }

  Cloud
  read()
  {
    cloud_.points.resize(header_.count);
    chooseCorner();
    if (window_.limits())
      readSelected();
    else
      blocks_.forEach(columns_.layers(), [this](std::size_t, const RecordBlock& block) {
        readBlock(block);
      });
    columns_.finish();
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
        columns_.layers(),
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
    columns_.read(block);
  }

  /** Chooses the shift near the box of the points, so that a part of a cloud can have
   * the same as the whole; near the first point if the header has no box; or near the
   * requested one. */
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

  const Source& source_;
  Window window_;
  std::shared_ptr<LasOrigin> origin_;
  LasHeader header_;
  LasBlocks blocks_;
  std::vector<std::string> selected_; ///< records in the window, by block
  Cloud cloud_;
  LasColumns columns_;
};

} // namespace

Cloud
readLas(const Source& source)
{
  return Reader(source).read();
}

} // namespace linelet::io
