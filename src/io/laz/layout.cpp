// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "layout.h"

#include "bytes.h"

namespace linelet::laz {

namespace {

constexpr std::size_t front_size = 34, item_size = 6;

struct Kind {
  Item::Type type;
  std::size_t size;
};

/** The items of a point format, without the extra bytes. */
std::vector<Kind>
kindsOf(int format)
{
  static const std::vector<std::vector<Kind>> kinds = [] {
    const Kind point10 = {Item::Point10, 20}, time = {Item::GpsTime11, 8},
               rgb12 = {Item::Rgb12, 6}, wave13 = {Item::WavePacket13, 29},
               point14 = {Item::Point14, 30}, rgb14 = {Item::Rgb14, 6},
               nir14 = {Item::RgbNir14, 8}, wave14 = {Item::WavePacket14, 29};
    return std::vector<std::vector<Kind>>{{point10},
                                          {point10, time},
                                          {point10, rgb12},
                                          {point10, time, rgb12},
                                          {point10, time, wave13},
                                          {point10, time, rgb12, wave13},
                                          {point14},
                                          {point14, rgb14},
                                          {point14, nir14},
                                          {point14, wave14},
                                          {point14, nir14, wave14}};
  }();
  return kinds.at(static_cast<std::size_t>(format));
}

std::vector<Kind>
kindsOf(int format, std::size_t record_length)
{
  std::vector<Kind> kinds = kindsOf(format);
  std::size_t length = 0;
  for (const Kind& kind : kinds)
    length += kind.size;
  if (record_length > length)
    kinds.push_back({format < 6 ? Item::Byte : Item::Byte14, record_length - length});
  return kinds;
}

/** Whether items of that kind were ever written in \a version. */
bool
isKnown(Item::Type type, unsigned version)
{
  switch (type) {
  case Item::WavePacket13:
    return version == 1;
  case Item::Byte:
  case Item::Point10:
  case Item::GpsTime11:
  case Item::Rgb12:
    return version == 1 || version == 2;
  case Item::WavePacket14:
    return version == 3 || version == 4;
  default: // a prototype wrote 2 for what became 3
    return version >= 2 && version <= 4;
  }
}

std::string
plural(std::size_t count, const std::string& what)
{
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

} // namespace

std::size_t
Layout::recordLength() const
{
  std::size_t length = 0;
  for (const Item& item : items)
    length += item.size;
  return length;
}

Layout
parseLayout(std::string_view data, int format, std::size_t record_length)
{
  const auto* at = reinterpret_cast<const std::uint8_t*>(data.data());
  if (data.size() < front_size)
    throw Error("its LAZ record has " + plural(data.size(), "byte") +
                ", less than the 34 that it needs");
  Layout layout;
  const auto compressor = load<std::uint16_t>(at);
  const bool layered = format >= 6;
  if (compressor < Layout::Pointwise || compressor > Layout::Layered ||
      (compressor == Layout::Layered) != layered)
    throw Error("its LAZ record names compressor " + std::to_string(compressor) +
                ", which does not belong to point format " + std::to_string(format));
  layout.compressor = static_cast<Layout::Compressor>(compressor);
  if (load<std::uint16_t>(at + 2) != 0)
    throw Error("its LAZ record names coder " +
                std::to_string(load<std::uint16_t>(at + 2)) +
                "; only 0, arithmetic coding, is known");
  layout.chunk_size = load<std::uint32_t>(at + 12);
  if (layout.chunk_size == 0)
    layout.chunk_size = Layout::variable;

  const std::size_t count = load<std::uint16_t>(at + 32);
  const std::vector<Kind> kinds = kindsOf(format, record_length);
  if (count != kinds.size() || data.size() < front_size + count * item_size)
    throw Error("its LAZ record lists " + plural(count, "item") + " of the " +
                std::to_string(kinds.size()) + " that point format " +
                std::to_string(format) + " with " + std::to_string(record_length) +
                " bytes is made of");
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* place = at + front_size + i * item_size;
    const unsigned type = load<std::uint16_t>(place);
    const std::size_t size = load<std::uint16_t>(place + 2);
    const unsigned version = load<std::uint16_t>(place + 4);
    const std::string name = "item " + std::to_string(i + 1) + " of its LAZ record";
    if (type != kinds[i].type || size != kinds[i].size)
      throw Error(name + " has type " + std::to_string(type) + " and " +
                  plural(size, "byte") + "; point format " + std::to_string(format) +
                  " has type " + std::to_string(kinds[i].type) + " and " +
                  plural(kinds[i].size, "byte") + " there");
    if (!isKnown(kinds[i].type, version))
      throw Error(name + " (type " + std::to_string(type) + ") has version " +
                  std::to_string(version) + ", which is not known");
    layout.items.push_back({kinds[i].type, size, version});
  }
  return layout;
}

Layout
layoutFor(int format, std::size_t record_length)
{
  Layout layout;
  layout.compressor = format < 6 ? Layout::Chunked : Layout::Layered;
  for (const Kind& kind : kindsOf(format, record_length)) {
    const unsigned version = kind.type == Item::WavePacket13 ? 1 : format < 6 ? 2 : 3;
    layout.items.push_back({kind.type, kind.size, version});
  }
  return layout;
}

std::string
textOf(const Layout& layout)
{
  std::string data(front_size + layout.items.size() * item_size, '\0');
  auto* at = reinterpret_cast<std::uint8_t*>(data.data());
  store<std::uint16_t>(at, layout.compressor);
  at[4] = layout.layered() ? 3 : 2; // the version of LASzip that introduced it
  at[5] = 2;
  store<std::uint32_t>(at + 12, layout.chunk_size);
  store<std::int64_t>(at + 16, -1); // no special extended records: neither number
  store<std::int64_t>(at + 24, -1); // nor offset
  store(at + 32, static_cast<std::uint16_t>(layout.items.size()));
  for (std::size_t i = 0; i < layout.items.size(); ++i) {
    std::uint8_t* place = at + front_size + i * item_size;
    store<std::uint16_t>(place, layout.items[i].type);
    store(place + 2, static_cast<std::uint16_t>(layout.items[i].size));
    store(place + 4, static_cast<std::uint16_t>(layout.items[i].version));
  }
  return data;
}

} // namespace linelet::laz
