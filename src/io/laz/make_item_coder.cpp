// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "make_item_coder.h"

#include "bytes.h"
#include "gps_time_v1.h"
#include "items.h"
#include "point10.h"
#include "point10_v1.h"

namespace linelet::laz {

namespace {

template <class Coder>
std::unique_ptr<ItemCoder<Coder>>
makeItemCoder(const Item& item, const std::uint8_t* first)
{
  switch (item.type) {
  case Item::Point10:
    return std::make_unique<Point10<Coder>>(first);
  case Item::GpsTime11:
    return std::make_unique<GpsTime11<Coder>>(first);
  case Item::Rgb12:
    return std::make_unique<Rgb12<Coder>>(first);
  case Item::WavePacket13:
    return std::make_unique<WavePacket13<Coder>>(first);
  case Item::Byte:
    return std::make_unique<Bytes<Coder>>(first, item.size);
  default:
    throw Error("item type " + std::to_string(item.type) + " belongs to layers");
  }
}

} // namespace

std::unique_ptr<ItemCoder<Decoder>>
makeItemDecoder(const Item& item, const std::uint8_t* first)
{
  if (item.version == 1)
    switch (item.type) {
    case Item::Point10:
      return std::make_unique<Point10V1>(first);
    case Item::GpsTime11:
      return std::make_unique<GpsTimeV1>(first);
    case Item::Rgb12:
      return std::make_unique<Rgb12V1>(first);
    case Item::Byte:
      return std::make_unique<BytesV1>(first, item.size);
    default:
      break;
    }
  return makeItemCoder<Decoder>(item, first);
}

std::unique_ptr<ItemCoder<Encoder>>
makeItemEncoder(const Item& item, const std::uint8_t* first)
{
  return makeItemCoder<Encoder>(item, first);
}

} // namespace linelet::laz
