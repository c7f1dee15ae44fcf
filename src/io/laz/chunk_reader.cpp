// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "chunk_reader.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bytes.h"
#include "decoder.h"
#include "layers.h"
#include "make_item_coder.h"
#include "records.h"

namespace linelet::laz {

namespace {

[[noreturn]] void
endsEarly()
{
  throw Error("its compressed data end before its last point");
}

/** Points of items that share one stream. */
std::size_t
readItems(const Layout& layout, std::string_view bytes, const Records& records)
{
  std::vector<std::unique_ptr<ItemCoder<Decoder>>> items;
  std::vector<std::size_t> places;
  std::size_t place = 0;
  for (const Item& item : layout.items) {
    items.push_back(makeItemDecoder(item, records.first + place));
    places.push_back(place);
    place += item.size;
  }
  if (records.count == 1 && bytes.size() == place)
    return place;
  const std::uint8_t* begin = beginOf(bytes);
  Decoder decoder(begin + place, begin + bytes.size());
  for (std::size_t i = 1; i < records.count && !decoder.overrun(); ++i)
    for (std::size_t k = 0; k < items.size(); ++k)
      items[k]->code(decoder, records.at(i) + places[k]);
  if (decoder.overrun())
    endsEarly();
  return static_cast<std::size_t>(decoder.next() - begin);
}

struct LayerSizes {
  std::uint32_t points = 0;
  std::vector<std::uint32_t> sizes;
  std::size_t first = 0; ///< byte of the first layer
  std::size_t end = 0;   ///< of the chunk
};

LayerSizes
readSizes(std::string_view bytes, std::size_t record_length, std::size_t layers)
{
  LayerSizes out;
  out.first = out.end = record_length + 4 + 4 * layers;
  if (bytes.size() < out.first)
    endsEarly();
  const std::uint8_t* at = beginOf(bytes) + record_length;
  out.points = load<std::uint32_t>(at);
  for (std::size_t i = 0; i < layers; ++i) {
    out.sizes.push_back(load<std::uint32_t>(at += 4));
    out.end += out.sizes.back();
    if (out.end > bytes.size())
      throw Error("layer " + std::to_string(i + 1) + " of its compressed data has " +
                  std::to_string(out.sizes.back()) + " bytes, more than are there");
  }
  return out;
}

/** Throws unless \a decoder of layer \a number ended where its bytes do. */
void
checkEnd(const Decoder& decoder, const std::uint8_t* end, std::size_t number)
{
  if (decoder.overrun())
    endsEarly();
  if (decoder.next() != end)
    throw Error("layer " + std::to_string(number) +
                " of its compressed data continues after its last point");
}

std::size_t
readLayers(const Layout& layout,
           std::string_view bytes,
           const Records& records,
           Fields wanted)
{
  const std::vector<Layer<Decoder>> layers = layersOf<Decoder>(layout);
  const LayerSizes sizes = readSizes(bytes, layout.recordLength(), layers.size() + 1);
  if (sizes.points != records.count)
    throw Error("its compressed data are of " + std::to_string(sizes.points) +
                " points instead of " + std::to_string(records.count));
  const std::uint8_t* at = beginOf(bytes) + sizes.first;
  const std::uint8_t* plan_end = at + sizes.sizes[0];
  Decoder plan_coder(at, plan_end);
  PlanLayer plan(records.first);
  at = plan_end;

  std::vector<std::unique_ptr<LayerCoder<Decoder>>> coders;
  std::vector<std::pair<std::size_t, const std::uint8_t*>> ends; // number, end
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::uint8_t* end = at + sizes.sizes[i + 1];
    if (at != end && (layers[i].field & wanted) != 0) {
      coders.push_back(
          layers[i].make(Decoder(at, end), records.first, layers[i].place));
      ends.emplace_back(i + 2, end);
    }
    at = end;
  }
  for (std::size_t i = 1; i < records.count && !plan_coder.overrun(); ++i) {
    // An empty layer has the value of the first point everywhere.
    if (records.stride != 0)
      std::copy_n(records.first, records.stride, records.at(i));
    const Note note = plan.code(plan_coder, records.at(i));
    for (const auto& coder : coders)
      coder->code(records.at(i), note);
  }
  if (records.count > 1)
    checkEnd(plan_coder, plan_end, 1);
  for (std::size_t i = 0; i < coders.size() && records.count > 1; ++i)
    checkEnd(coders[i]->coder, ends[i].second, ends[i].first);
  return sizes.end;
}

} // namespace

std::size_t
readChunk(const Layout& layout,
          std::string_view bytes,
          std::size_t count,
          std::uint8_t* records,
          Fields wanted)
{
  const Records all = {records, layout.recordLength(), count};
  if (count == 0)
    return 0;
  if (bytes.size() < all.stride)
    endsEarly();
  std::copy_n(beginOf(bytes), all.stride, records);
  return layout.layered() ? readLayers(layout, bytes, all, wanted)
                          : readItems(layout, bytes, all);
}

std::size_t
skipChunk(const Layout& layout, std::string_view bytes, std::size_t count)
{
  const std::size_t length = layout.recordLength();
  if (bytes.size() < length)
    endsEarly();
  std::vector<std::uint8_t> record(beginOf(bytes), beginOf(bytes) + length);
  const Records all = {record.data(), 0, count};
  return layout.layered() ? readLayers(layout, bytes, all, 0)
                          : readItems(layout, bytes, all);
}

ChunkSize
layeredChunkSize(const Layout& layout, std::string_view bytes)
{
  const LayerSizes sizes =
      readSizes(bytes, layout.recordLength(), layersOf<Decoder>(layout).size() + 1);
  return {sizes.end, sizes.points};
}

} // namespace linelet::laz
