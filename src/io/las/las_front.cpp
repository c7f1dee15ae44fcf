// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "las_front.h"

#include <algorithm>
#include <cmath>

#include <linelet/io/file_error.h>
#include <linelet/support/threads.h>

#include "io/columns.h"
#include "io/source.h"
#include "las_header.h"

namespace linelet::io {

namespace {

std::uint64_t
lengthOf(const std::vector<LasRecord>& records)
{
  std::uint64_t length = 0;
  for (const LasRecord& record : records)
    length += record.head.size() + record.data.size();
  return length;
}

} // namespace

LasFront::LasFront(const FileWork& target, const Cloud& cloud, bool compress)
    : target_(target),
      cloud_(cloud),
      steps_(cloud, target.threads),
      layout_(chooseLasLayout(cloud))
{
  if (layout_.record_length > 65535)
    throw FileError(target.name + ": " + std::to_string(layout_.record_length) +
                    " bytes per point are more than the 65535 of a LAS record; write "
                    "fewer attributes");
  if (steps_.replaced())
    target.warn("the points do not fit the integer grid of the file they came from; "
                "a new scale and offset are chosen");
  if (cloud.las != nullptr && !layout_.as_origin)
    target.warn("point format " + std::to_string(cloud.las->format) +
                " cannot hold the attributes; written as LAS 1.4 point format " +
                std::to_string(layout_.format));
  for (const std::string& name : layout_.rounded)
    target.warn("attribute '" + name +
                "' is rounded to what LAS holds under that "
                "name; its exact values are in extra bytes");
  chooseRecords();
  if (compress) {
    compression_ = laz::layoutFor(layout_.format, layout_.record_length);
    records_.push_back(makeLasRecord(
        laz::record_user, laz::record_number, "linelet", laz::textOf(*compression_)));
  }
  startHeader();
}

bool
LasFront::agreesWith(const LasFront& other) const
{
  const LasGrid &a = steps_.grid(), &b = other.steps_.grid();
  return layout_.format == other.layout_.format &&
         layout_.record_length == other.layout_.record_length && a.scale == b.scale &&
         a.offset == b.offset &&
         layout_.extras_as_origin == other.layout_.extras_as_origin &&
         layout_.color_factor == other.layout_.color_factor;
}

bool
LasFront::sameReference() const
{
  return cloud_.las != nullptr && cloud_.las->wkt == cloud_.wkt &&
         (layout_.as_origin || layout_.format < 6);
}

bool
LasFront::keeps(const LasRecord& record) const
{
  // Spatial indices of the input are not valid for this file.
  if (record.user() == "copc" || record.is("LAStools", 30))
    return false;
  if (record.is("LASF_Spec", 4))
    return layout_.extras_as_origin;
  return sameReference() || record.user() != "LASF_Projection";
}

void
LasFront::chooseRecords()
{
  if (const LasOrigin* origin = cloud_.las.get()) {
    for (const LasRecord& record : origin->records)
      if (keeps(record))
        records_.push_back(record);
    for (const LasRecord& record : origin->extended)
      if (keeps(record))
        extended_.push_back(record);
    if (layout_.as_origin)
      gap_ = origin->gap;
  }
  if (!layout_.extras_as_origin)
    describeExtras();
  if (!sameReference() && !cloud_.wkt.empty()) {
    if (cloud_.wkt.size() < 65535)
      records_.push_back(makeLasRecord(
          "LASF_Projection", 2112, "reference system (WKT)", cloud_.wkt + '\0'));
    else
      target_.warn("the reference system is too long for a LAS record");
  }
}

void
LasFront::describeExtras()
{
  constexpr std::size_t most = 65535 / las_descriptor_size;
  for (std::size_t first = 0; first < layout_.extras.size(); first += most) {
    std::string text;
    const std::size_t end = std::min(first + most, layout_.extras.size());
    for (std::size_t i = first; i < end; ++i) {
      const LasExtra& extra = layout_.extras[i];
      text += extra.descriptor;
      for (const std::string& name : extra.columns)
        if (name.size() > 32)
          target_.warn("attribute '" + name + "' is called '" + name.substr(0, 32) +
                       "' in extra bytes");
    }
    records_.push_back(makeLasRecord("LASF_Spec", 4, "extra bytes", text));
  }
}

template <class T>
void
LasFront::put(std::size_t at, T value)
{
  store(&header_[at], value);
}

void
LasFront::startHeader()
{
  if (layout_.as_origin)
    header_ = cloud_.las->header;
  else {
    header_ = cloud_.las != nullptr ? cloud_.las->header.substr(0, las_header_10)
                                    : std::string("LASF");
    header_.resize(las_header_14, '\0');
    header_[24] = 1;
    header_[las_at::minor] = 4;
    if (cloud_.las == nullptr)
      std::string_view("OTHER").copy(&header_[26], 32);
    put<std::uint16_t>(las_at::header_size, las_header_14);
  }
  const bool wkt =
      std::any_of(records_.begin(), records_.end(), [](const LasRecord& record) {
        return record.is("LASF_Projection", 2112);
      });
  if (!sameReference() || !layout_.as_origin) {
    unsigned encoding = load<std::uint16_t>(&header_[las_at::global_encoding]);
    encoding &= ~las_wkt_bit;
    if (layout_.format >= 6 || (wkt && !sameReference()))
      encoding |= las_wkt_bit;
    put(las_at::global_encoding, static_cast<std::uint16_t>(encoding));
  }
  std::fill_n(header_.begin() + las_at::software, 32, '\0');
  std::string_view("linelet").copy(&header_[las_at::software], 32);
  header_[las_at::format] =
      static_cast<char>(layout_.format | (compression_ ? 0x80 : 0));
  put(las_at::record_length, static_cast<std::uint16_t>(layout_.record_length));
  put(las_at::records, static_cast<std::uint32_t>(records_.size()));
  for (int axis = 0; axis < 3; ++axis) {
    put(las_at::scale + 8 * static_cast<std::size_t>(axis), steps_.grid().scale[axis]);
    put(las_at::offset + 8 * static_cast<std::size_t>(axis),
        steps_.grid().offset[axis]);
  }
}

void
LasFront::placeParts(std::uint64_t bytes)
{
  const std::uint64_t points_at = header_.size() + lengthOf(records_) + gap_.size();
  if (points_at > 0xFFFFFFFFU)
    throw FileError(target_.name + ": more than 4 GB before the points");
  put(las_at::points, static_cast<std::uint32_t>(points_at));
  const std::uint64_t end = points_at + bytes;
  const int minor = static_cast<unsigned char>(header_[las_at::minor]);
  if (minor >= 3)
    placeWaveform(end);
  if (minor < 4)
    return;
  put<std::uint64_t>(las_at::extended, extended_.empty() ? 0 : end);
  put(las_at::extended_count, static_cast<std::uint32_t>(extended_.size()));
}

/** Updates the offset of the waveform packets to the new place of their record. */
void
LasFront::placeWaveform(std::uint64_t end)
{
  if (cloud_.las == nullptr || cloud_.las->header.size() < las_header_13)
    return;
  const LasOrigin& origin = *cloud_.las;
  const auto stated = load<std::uint64_t>(&origin.header[las_at::waveform]);
  std::uint64_t from = stated;
  if (origin.header[las_at::minor] >= 4)
    from = load<std::uint64_t>(&origin.header[las_at::extended]);
  std::uint64_t to = end;
  put(las_at::waveform, stated);
  for (const LasRecord& record : origin.extended) {
    if (from == stated && keeps(record))
      return put(las_at::waveform, to);
    from += record.head.size() + record.data.size();
    if (keeps(record))
      to += record.head.size() + record.data.size();
  }
}

void
LasTotals::add(const std::array<std::int32_t, 3>& at, double return_number)
{
  add({1, {}, at, at});
  if (return_number >= 1 && return_number <= 15)
    ++returns[static_cast<std::size_t>(return_number) - 1];
}

void
LasTotals::add(const LasTotals& more)
{
  if (more.points == 0)
    return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis] = points == 0 ? more.low[axis] : std::min(low[axis], more.low[axis]);
    high[axis] = points == 0 ? more.high[axis] : std::max(high[axis], more.high[axis]);
  }
  points += more.points;
  for (std::size_t i = 0; i < returns.size(); ++i)
    returns[i] += more.returns[i];
}

void
LasFront::count(LasTotals& totals) const
{
  const Column* number = layout_.fields[1]; // return_number in every format
#pragma omp parallel num_threads(threadCount(target_.threads))
  {
    LasTotals part;
#pragma omp for schedule(static)
    for (std::size_t i = 0; i < cloud_.points.size(); ++i)
      part.add(steps_(i), number == nullptr ? 1 : valueAt(*number, i));
#pragma omp critical(linelet_las_totals)
    totals.add(part);
  }
}

/** Counts, returns and bounds. */
void
LasFront::putTotals(const LasTotals& totals)
{
  for (std::size_t axis = 0; axis < 3 && totals.points > 0; ++axis) {
    const double scale = steps_.grid().scale[static_cast<int>(axis)];
    const double offset = steps_.grid().offset[static_cast<int>(axis)];
    const double a = totals.low[axis] * scale + offset,
                 b = totals.high[axis] * scale + offset;
    put(las_at::bounds + 16 * axis, std::max(a, b));
    put(las_at::bounds + 16 * axis + 8, std::min(a, b));
  }
  const bool large = header_[las_at::minor] >= 4;
  if (!large && totals.points > 0xFFFFFFFFU)
    throw FileError(target_.name + ": too many points for LAS before 1.4");
  // The legacy fields (before 1.4) are zero if the counts do not fit.
  const bool old = layout_.format < 6 && totals.points <= 0xFFFFFFFFU;
  put(las_at::count, static_cast<std::uint32_t>(old ? totals.points : 0));
  for (std::size_t i = 0; i < 5; ++i)
    put(las_at::returns + 4 * i,
        static_cast<std::uint32_t>(old ? totals.returns[i] : 0));
  if (!large)
    return;
  put<std::uint64_t>(las_at::count64, totals.points);
  for (std::size_t i = 0; i < 15; ++i)
    put(las_at::returns64 + 8 * i, totals.returns[i]);
}

std::string
LasFront::before(const LasTotals& totals, std::uint64_t bytes)
{
  putTotals(totals);
  placeParts(bytes);
  std::string text = header_;
  for (const LasRecord& record : records_)
    text += record.head + record.data;
  return text + gap_;
}

std::string
LasFront::behind() const
{
  std::string text;
  for (const LasRecord& record : extended_)
    text += record.head + record.data;
  return text;
}

std::string
LasFront::makeRecords(std::size_t first, std::size_t number) const
{
  const auto& fields = lasFields(layout_.format);
  std::string records(number * layout_.record_length, '\0');
  const LasBlock block{records.data(), layout_.record_length, first, number};
  for (std::size_t i = 0; i < number; ++i) {
    const auto at = steps_(first + i);
    for (std::size_t axis = 0; axis < 3; ++axis)
      store(records.data() + i * layout_.record_length + 4 * axis, at[axis]);
  }
  for (std::size_t i = 0; i < fields.size(); ++i)
    writeLasField(fields[i],
                  layout_.fields[i],
                  isColor(fields[i].name) ? layout_.color_factor : 1,
                  block);
  std::size_t at = lasRecordLength(layout_.format);
  for (const LasExtra& extra : layout_.extras) {
    writeLasExtra(extra, at, cloud_, block);
    at += extra.bytes;
  }
  return records;
}

} // namespace linelet::io
