// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "las_header.h"

#include <algorithm>
#include <cmath>

#include <linelet/support/text.h>

namespace linelet::io {

namespace {

std::string
at(std::uint64_t place)
{
  return " at byte " + std::to_string(place);
}

/** Reads records of the given head size from \a place up to \a end; returns the end of
 * the last complete one. */
std::uint64_t
readRecords(const Source& source,
            std::uint64_t place,
            std::uint64_t end,
            std::uint64_t count,
            std::size_t head_size,
            std::vector<LasRecord>& records)
{
  for (; count > 0 && place <= end && end - place >= head_size; --count) {
    const char* head = source.bytes.data() + place;
    const std::uint64_t length = head_size == 54 ? load<std::uint16_t>(head + 20)
                                                 : load<std::uint64_t>(head + 20);
    if (length > end - place - head_size)
      break;
    records.push_back(
        {std::string(head, head_size),
         std::string(head + head_size, static_cast<std::size_t>(length))});
    place += head_size + length;
  }
  return place;
}

void
checkScale(const Source& source, LasGrid& grid)
{
  const char* header = source.bytes.data();
  for (int axis = 0; axis < 3; ++axis) {
    grid.scale[axis] = load<double>(header + las_at::scale + 8 * axis);
    grid.offset[axis] = load<double>(header + las_at::offset + 8 * axis);
    const std::string name = std::string(" of ") + "xyz"[axis];
    const double extreme = 0x1p32 * grid.scale[axis];
    if (!std::isnormal(grid.scale[axis]) || !std::isfinite(extreme))
      source.fail("scale factor" + name + " is " + textOf(grid.scale[axis]) +
                  at(las_at::scale + 8 * static_cast<std::size_t>(axis)) +
                  "; coordinates cannot be computed");
    if (!std::isfinite(grid.offset[axis]) ||
        !std::isfinite(grid.offset[axis] + extreme))
      source.fail("offset" + name + " is not a usable number" +
                  at(las_at::offset + 8 * static_cast<std::size_t>(axis)));
  }
}

/** Size of the header, after all checks that need nothing else. */
std::size_t
checkFront(const Source& source, LasHeader& header, LasOrigin& origin)
{
  const std::string_view bytes = source.bytes;
  if (bytes.empty())
    source.fail("the file is empty");
  if (bytes.substr(0, 4) != std::string_view("LASF").substr(0, bytes.size()))
    source.fail("not a LAS file: it does not begin with 'LASF'");
  if (bytes.size() < las_header_10)
    source.fail("the file ends within the header, after " +
                std::to_string(bytes.size()) + " of at least 227 bytes");
  const auto major = static_cast<unsigned char>(bytes[24]);
  header.minor = static_cast<unsigned char>(bytes[las_at::minor]);
  if (major != 1 || header.minor > 5)
    source.fail("LAS version " + std::to_string(major) + "." +
                std::to_string(header.minor) +
                " at byte 24 is not known; linelet reads 1.0 to 1.4");
  if (header.minor == 5)
    source.warn(
        "LAS version 1.5 is read as 1.4; its additions are kept but not interpreted");

  // The upper two bits mark compressed points.
  const unsigned format = static_cast<unsigned char>(bytes[las_at::format]) & 0x3FU;
  if (format > 10)
    source.fail("point format " +
                std::to_string(static_cast<unsigned char>(bytes[las_at::format])) +
                " at byte 104 is not known; LAS has formats 0 to 10");
  origin.format = static_cast<int>(format);
  const std::size_t size = load<std::uint16_t>(bytes.data() + las_at::header_size);
  const std::size_t least = header.minor >= 4   ? las_header_14
                            : header.minor == 3 ? las_header_13
                                                : las_header_10;
  if (size < least)
    source.fail("header size " + std::to_string(size) +
                " at byte 94 is less than the " + std::to_string(least) +
                " bytes of LAS 1." + std::to_string(header.minor));
  if (size > bytes.size())
    source.fail("the file ends within the header, after " +
                std::to_string(bytes.size()) + " of " + std::to_string(size) +
                " bytes");
  header.record_length = load<std::uint16_t>(bytes.data() + las_at::record_length);
  if (header.record_length < lasRecordLength(origin.format))
    source.fail("point record length " + std::to_string(header.record_length) +
                " at byte 105 is less than the " +
                std::to_string(lasRecordLength(origin.format)) +
                " bytes of point format " + std::to_string(format));
  header.points_at = load<std::uint32_t>(bytes.data() + las_at::points);
  if (header.points_at < size)
    source.fail("offset to the points " + std::to_string(header.points_at) +
                " at byte 96 lies within the header of " + std::to_string(size) +
                " bytes");
  return size;
}

std::uint64_t
statedCount(const Source& source, const LasHeader& header)
{
  const std::uint64_t legacy = load<std::uint32_t>(source.bytes.data() + las_at::count);
  if (header.minor < 4)
    return legacy;
  const auto count = load<std::uint64_t>(source.bytes.data() + las_at::count64);
  if (count == 0)
    return legacy; // some writers of 1.4 fill in only the old count
  if (legacy != 0 && legacy != count)
    source.warn("the point counts at bytes 107 (" + std::to_string(legacy) +
                ") and 247 (" + std::to_string(count) +
                ") differ; the latter, of LAS 1.4, is used");
  return count;
}

void
readFrontRecords(const Source& source, LasHeader& header, LasOrigin& origin)
{
  const std::uint64_t size = source.bytes.size();
  const std::uint64_t stated =
      load<std::uint32_t>(source.bytes.data() + las_at::records);
  const std::uint64_t end = std::min<std::uint64_t>(header.points_at, size);
  const std::uint64_t place =
      readRecords(source, origin.header.size(), end, stated, 54, origin.records);
  if (origin.records.size() < stated && header.points_at <= size)
    source.warn("the header says " + std::to_string(stated) +
                " variable length records, but only " +
                std::to_string(origin.records.size()) + " fit before the points" +
                at(header.points_at));
  if (place < end && origin.records.size() == stated)
    origin.gap = source.bytes.substr(place, end - place);
}

void
readExtendedRecords(const Source& source, const LasHeader& header, LasOrigin& origin)
{
  const char* bytes = source.bytes.data();
  const std::uint64_t size = source.bytes.size();
  std::uint64_t place = 0, stated = 0;
  if (header.minor >= 4) {
    place = load<std::uint64_t>(bytes + las_at::extended);
    stated = load<std::uint32_t>(bytes + las_at::extended_count);
  }
  else if (header.minor == 3 && hasWaveform(origin.format)) {
    place = load<std::uint64_t>(bytes + las_at::waveform);
    stated = place != 0 ? 1 : 0; // 0: the waveforms are in a separate file
  }
  if (stated == 0)
    return;
  if (place < origin.header.size())
    return source.warn("the place of the extended records" + at(place) +
                       " lies within the header; they are left out");
  readRecords(source, place, size, stated, 60, origin.extended);
  if (origin.extended.size() < stated)
    source.endsEarly("the file ends after " + std::to_string(size) + " bytes, before " +
                     std::to_string(stated - origin.extended.size()) + " of " +
                     std::to_string(stated) + " extended records that begin" +
                     at(place));
}

/** Counts the complete records of an uncompressed file. */
void
countRecords(const Source& source, std::uint64_t stated, LasHeader& header)
{
  const std::size_t there =
      source.bytes.size() > header.points_at
          ? (source.bytes.size() - header.points_at) / header.record_length
          : 0;
  header.count = static_cast<std::size_t>(std::min<std::uint64_t>(stated, there));
  if (header.points_at > source.bytes.size())
    source.endsEarly("the file ends after " + std::to_string(source.bytes.size()) +
                     " bytes, before the points" + at(header.points_at));
  else if (header.count < stated)
    source.endsEarly("the header says " + std::to_string(stated) +
                     " points, but the file ends after " +
                     std::to_string(header.count) + " whole ones (points" +
                     at(header.points_at) + ", " +
                     std::to_string(header.record_length) + " bytes each)");
}

/** Removes the LASzip record, which must not be copied into a new file. */
void
takeCompression(const Source& source, const LasHeader& header, LasOrigin& origin)
{
  const auto place = std::find_if(
      origin.records.begin(), origin.records.end(), [](const LasRecord& record) {
        return record.is(laz::record_user, laz::record_number);
      });
  if (place == origin.records.end())
    source.fail("its points are compressed (point format byte at 104), but it has no "
                "record 'laszip encoded' that says how");
  try {
    origin.compression =
        laz::parseLayout(place->data, origin.format, header.record_length);
  }
  catch (const laz::Error& error) {
    source.fail(error.what());
  }
  origin.records.erase(place);
  origin.header[las_at::format] = static_cast<char>(origin.format);
}

} // namespace

std::pair<double, double>
lasBounds(const LasOrigin& origin, int axis)
{
  const char* at = origin.header.data() + las_at::bounds + 16 * axis;
  return {load<double>(at + 8), load<double>(at)};
}

std::string
formatName(const LasHeader& header, const LasOrigin& origin)
{
  const bool copc =
      std::any_of(origin.records.begin(),
                  origin.records.end(),
                  [](const LasRecord& record) { return record.is("copc", 1); });
  return std::string(copc && origin.compression ? "COPC, " : "") +
         (origin.compression ? "LAZ" : "LAS") + " 1." + std::to_string(header.minor) +
         ", point format " + std::to_string(origin.format);
}

LasHeader
readLasHeader(const Source& source, LasOrigin& origin)
{
  LasHeader header;
  const std::size_t size = checkFront(source, header, origin);
  origin.header = source.bytes.substr(0, size);
  checkScale(source, origin.grid);

  const std::uint64_t stated = statedCount(source, header);
  const bool compressed =
      (static_cast<unsigned char>(source.bytes[las_at::format]) & 0xC0U) != 0;
  if (compressed)
    header.count = static_cast<std::size_t>(stated);
  else
    countRecords(source, stated, header);
  readFrontRecords(source, header, origin);
  readExtendedRecords(source, header, origin);
  if (compressed)
    takeCompression(source, header, origin);
  return header;
}

} // namespace linelet::io
