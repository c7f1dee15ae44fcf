// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "las_layout.h"

#include <algorithm>

#include "las_encode.h"

namespace linelet::io {

namespace {

const LasField*
fieldOf(int format, std::string_view name)
{
  for (const LasField& field : lasFields(format))
    if (field.name == name)
      return &field;
  return nullptr;
}

/** Whether \a column corresponds to a field of the point record. */
bool
isNative(const Cloud& cloud, const Column& column)
{
  if (isLasName(column.name))
    return true;
  return cloud.las != nullptr && hasWaveform(cloud.las->format) &&
         fieldOf(10, column.name) != nullptr;
}

bool
holds(int format, const Cloud& cloud)
{
  return std::all_of(
      cloud.columns.begin(), cloud.columns.end(), [&](const Column& column) {
        if (!isNative(cloud, column))
          return true;
        const LasField* field = fieldOf(format, column.name);
        return field != nullptr && fitsLasField(*field, column);
      });
}

int
chooseFormat(const Cloud& cloud)
{
  const bool waveform = cloud.las != nullptr && hasWaveform(cloud.las->format);
  std::vector<int> candidates;
  if (cloud.las != nullptr)
    candidates.push_back(cloud.las->format);
  for (int format :
       waveform ? std::vector<int>{4, 5, 9, 10} : std::vector<int>{0, 1, 2, 3, 6, 7, 8})
    candidates.push_back(format);
  for (int format : candidates)
    if (holds(format, cloud))
      return format;
  if (waveform)
    return 10;
  if (cloud.find("nir") != nullptr)
    return 8;
  return cloud.find("red") != nullptr ? 7 : 6;
}

bool
isByte(const Column* column)
{
  return column != nullptr && typeOf(*column) == ValueType::UInt8;
}

/** The columns that the format has no field for, or whose values the field cannot
 * hold. */
std::vector<const Column*>
chooseFields(const Cloud& cloud, LasLayout& layout)
{
  const auto& fields = lasFields(layout.format);
  layout.fields.assign(fields.size(), nullptr);
  std::vector<const Column*> rest;
  for (const Column& column : cloud.columns) {
    const LasField* field =
        isNative(cloud, column) ? fieldOf(layout.format, column.name) : nullptr;
    const bool fits = field != nullptr && fitsLasField(*field, column);
    if (field != nullptr)
      layout.fields[static_cast<std::size_t>(field - fields.data())] = &column;
    if (field != nullptr && !fits)
      layout.rounded.push_back(column.name);
    if (!fits)
      rest.push_back(&column);
  }
  // LAS colors have 16 bits; 8-bit ones go into the upper half.
  if (isByte(cloud.find("red")) && isByte(cloud.find("green")) &&
      isByte(cloud.find("blue")))
    layout.color_factor = 256;
  return rest;
}

/** Keeps the entries of the origin whose columns still exist. */
void
keepExtras(const Cloud& cloud, LasLayout& layout, std::vector<const Column*>& rest)
{
  if (cloud.las == nullptr)
    return;
  for (const LasExtra& extra : cloud.las->extras) {
    const auto present = [&](const std::string& name) {
      return std::any_of(
          rest.begin(), rest.end(), [&](const Column* c) { return c->name == name; });
    };
    const bool whole = std::all_of(extra.columns.begin(), extra.columns.end(), present);
    if (!whole || (extra.columns.empty() &&
                   extra.raw.size() != extra.bytes * cloud.points.size()))
      continue;
    for (const std::string& name : extra.columns)
      rest.erase(std::find_if(
          rest.begin(), rest.end(), [&](const Column* c) { return c->name == name; }));
    layout.extras.push_back(extra);
  }
}

} // namespace

LasLayout
chooseLasLayout(const Cloud& cloud)
{
  LasLayout layout;
  layout.format = chooseFormat(cloud);
  layout.as_origin = cloud.las != nullptr && cloud.las->format == layout.format;
  std::vector<const Column*> rest = chooseFields(cloud, layout);
  keepExtras(cloud, layout, rest);
  layout.extras_as_origin = cloud.las != nullptr && rest.empty() &&
                            layout.extras.size() == cloud.las->extras.size();
  for (const Column* column : rest)
    layout.extras.push_back(describeLasExtra(*column));
  layout.record_length = lasRecordLength(layout.format);
  for (const LasExtra& extra : layout.extras)
    layout.record_length += extra.bytes;
  return layout;
}

} // namespace linelet::io
