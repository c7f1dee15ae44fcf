// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "las_store.h"

#include <cmath>

#include "io/las/las_format.h"
#include "io/las/las_header.h"

namespace linelet::io::hdf5 {

namespace {

void
writeBytes(const Handle& group, const std::string& name, const std::string& bytes)
{
  Column1D(group, name, H5T_STD_U8LE, H5T_NATIVE_UINT8)
      .append(bytes.data(), bytes.size());
}

std::string
readBytes(const Handle& group, const std::string& name)
{
  const StoredColumn column(group, name);
  const auto bytes = column.all<std::uint8_t>(H5T_NATIVE_UINT8);
  return {bytes.begin(), bytes.end()};
}

std::vector<std::int64_t>
readIntegers(const Handle& group, const std::string& name)
{
  return StoredColumn(group, name).all<std::int64_t>(H5T_NATIVE_INT64);
}

void
writeIntegers(const Handle& group,
              const std::string& name,
              const std::vector<std::int64_t>& values)
{
  writeValues(group, name, ValueType::Int64, values);
}

/** \brief The concatenated records, and the lengths of their heads and data. */
void
writeRecords(const Handle& group,
             const std::string& name,
             const std::vector<LasRecord>& records)
{
  std::string bytes;
  std::vector<std::int64_t> lengths;
  for (const LasRecord& record : records) {
    bytes += record.head + record.data;
    lengths.push_back(static_cast<std::int64_t>(record.head.size()));
    lengths.push_back(static_cast<std::int64_t>(record.data.size()));
  }
  writeBytes(group, name, bytes);
  writeIntegers(group, name + "_lengths", lengths);
}

std::vector<LasRecord>
readRecords(const Handle& group, const std::string& name, std::int64_t head)
{
  const std::string bytes = readBytes(group, name);
  const auto lengths = readIntegers(group, name + "_lengths");
  std::vector<LasRecord> records;
  std::size_t at = 0;
  const auto take = [&](std::int64_t length) {
    if (length < 0 || static_cast<std::uint64_t>(length) > bytes.size() - at)
      throw Error("the lengths of its LAS records are wrong");
    std::string part = bytes.substr(at, static_cast<std::size_t>(length));
    at += part.size();
    return part;
  };
  for (std::size_t i = 0; i + 1 < lengths.size(); i += 2) {
    if (lengths[i] != head)
      throw Error("the lengths of its LAS records are wrong");
    LasRecord record;
    record.head = take(lengths[i]);
    record.data = take(lengths[i + 1]);
    records.push_back(std::move(record));
  }
  return records;
}

std::vector<double>
numbersOf(const Point& p)
{
  return {p.x(), p.y(), p.z()};
}

Point
pointAttribute(const Handle& object, const char* name)
{
  const std::vector<double> values = numbersAttribute(object, name, 3);
  return Point(values.data());
}

void
writeExtras(const Handle& group, const std::vector<LasExtra>& extras)
{
  std::string descriptors, names;
  std::vector<std::int64_t> forms;
  std::vector<double> scales;
  for (const LasExtra& extra : extras) {
    descriptors += extra.descriptor;
    forms.push_back(static_cast<std::int64_t>(extra.type));
    forms.push_back(static_cast<std::int64_t>(extra.bytes));
    forms.push_back(static_cast<std::int64_t>(extra.columns.size()));
    for (std::size_t c = 0; c < 3; ++c) {
      forms.push_back(extra.scaled[c]);
      scales.push_back(extra.scale[c]);
      scales.push_back(extra.offset[c]);
    }
    for (const std::string& name : extra.columns)
      names += name + '\n'; // names contain no line ends
  }
  writeBytes(group, "extra_descriptors", descriptors);
  writeBytes(group, "extra_names", names);
  writeIntegers(group, "extra_forms", forms);
  writeValues(group, "extra_scales", ValueType::Float64, scales);
}

std::vector<LasExtra>
readExtras(const Handle& group, const Cloud& cloud)
{
  const Error damaged("its description of LAS extra bytes is wrong");
  const std::string descriptors = readBytes(group, "extra_descriptors");
  std::string names = readBytes(group, "extra_names");
  const auto forms = readIntegers(group, "extra_forms");
  const auto scales =
      StoredColumn(group, "extra_scales").all<double>(H5T_NATIVE_DOUBLE);
  const std::size_t count = forms.size() / 6;
  if (descriptors.size() != count * las_descriptor_size || scales.size() != count * 6)
    throw damaged;
  std::vector<LasExtra> extras;
  std::size_t name_at = 0, total = 0;
  for (std::size_t e = 0; e < count; ++e) {
    const std::int64_t* form = &forms[6 * e];
    LasExtra extra;
    if (form[0] < 0 || form[0] > static_cast<int>(ValueType::Float64) || form[1] < 1 ||
        form[1] > 65535 || form[2] < 0 || form[2] > 3)
      throw damaged;
    extra.descriptor = descriptors.substr(e * las_descriptor_size, las_descriptor_size);
    extra.type = static_cast<ValueType>(form[0]);
    extra.bytes = static_cast<std::size_t>(form[1]);
    total += extra.bytes;
    const auto columns = static_cast<std::size_t>(form[2]);
    if (columns > 0 && extra.bytes != columns * sizeOf(extra.type))
      throw damaged;
    for (std::size_t c = 0; c < 3; ++c) {
      extra.scaled[c] = form[3 + c] != 0;
      extra.scale[c] = scales[6 * e + 2 * c];
      extra.offset[c] = scales[6 * e + 2 * c + 1];
    }
    for (std::size_t c = 0; c < columns; ++c) {
      const std::size_t end = names.find('\n', name_at);
      if (end == std::string::npos)
        throw damaged;
      extra.columns.push_back(names.substr(name_at, end - name_at));
      name_at = end + 1;
      const Column* column = cloud.find(extra.columns.back());
      const ValueType type = extra.scaled[c] ? ValueType::Float64 : extra.type;
      if (column == nullptr || typeOf(*column) != type)
        throw damaged;
    }
    extras.push_back(std::move(extra));
  }
  if (total > 65535)
    throw damaged;
  return extras;
}

} // namespace

std::string
rawName(std::size_t number)
{
  return "extra_bytes_" + std::to_string(number);
}

void
writeLasOrigin(const Handle& group, const LasOrigin& origin)
{
  writeBytes(group, "header", origin.header);
  writeBytes(group, "gap", origin.gap);
  writeRecords(group, "records", origin.records);
  writeRecords(group, "extended_records", origin.extended);
  setAttribute(group, "point_format", std::vector<std::int64_t>{origin.format});
  setAttribute(group, "scale", numbersOf(origin.grid.scale));
  setAttribute(group, "offset", numbersOf(origin.grid.offset));
  setAttribute(
      group,
      "corner",
      std::vector<std::int64_t>(origin.grid.corner.begin(), origin.grid.corner.end()));
  setAttribute(group, "shift", numbersOf(origin.shift));
  if (!origin.wkt.empty())
    setAttribute(group, "wkt", origin.wkt);
  writeExtras(group, origin.extras);
}

std::shared_ptr<LasOrigin>
readLasOrigin(const Handle& group, const Cloud& cloud)
{
  auto origin = std::make_shared<LasOrigin>();
  origin->header = readBytes(group, "header");
  const std::size_t length = origin->header.size();
  const int minor = length > las_at::minor ? origin->header[las_at::minor] : -1;
  const std::int64_t format = integerAttribute(group, "point_format", -1);
  if (minor < 0 || minor > 9 || format < 0 || format > 10 ||
      length < (minor >= 4   ? las_header_14
                : minor == 3 ? las_header_13
                             : las_header_10) ||
      length > 65535)
    throw Error("its LAS header is damaged");
  origin->format = static_cast<int>(format);
  origin->gap = readBytes(group, "gap");
  origin->records = readRecords(group, "records", 54);
  origin->extended = readRecords(group, "extended_records", 60);
  origin->grid.scale = pointAttribute(group, "scale");
  origin->grid.offset = pointAttribute(group, "offset");
  const auto corner = integersAttribute(group, "corner", 3);
  std::copy(corner.begin(), corner.end(), origin->grid.corner.begin());
  origin->shift = pointAttribute(group, "shift");
  origin->wkt = textAttribute(group, "wkt");
  for (int axis = 0; axis < 3; ++axis)
    if (!(std::abs(origin->grid.scale[axis]) > 0) ||
        !std::isfinite(origin->grid.scale[axis]) ||
        !std::isfinite(origin->grid.offset[axis]) ||
        std::abs(static_cast<double>(corner[static_cast<std::size_t>(axis)])) > 0x1p40)
      throw Error("its LAS scale or offset is damaged");
  origin->extras = readExtras(group, cloud);
  return origin;
}

} // namespace linelet::io::hdf5
