// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "chunk_writer.h"

#include <algorithm>
#include <memory>

#include "bytes.h"
#include "encoder.h"
#include "layers.h"
#include "make_item_coder.h"
#include "records.h"

namespace linelet::laz {

namespace {

using Bytes8 = std::vector<std::uint8_t>;

void
append(Bytes8& to, const Bytes8& more)
{
  to.insert(to.end(), more.begin(), more.end());
}

Bytes8
writeItems(const Layout& layout, const Records& records)
{
  std::vector<std::unique_ptr<ItemCoder<Encoder>>> items;
  std::vector<std::size_t> places;
  std::size_t place = 0;
  for (const Item& item : layout.items) {
    items.push_back(makeItemEncoder(item, records.first + place));
    places.push_back(place);
    place += item.size;
  }
  Encoder encoder;
  for (std::size_t i = 1; i < records.count; ++i)
    for (std::size_t k = 0; k < items.size(); ++k)
      items[k]->code(encoder, records.at(i) + places[k]);
  return encoder.finish();
}

/** Whether the field of \a layer varies among the points. */
bool
varies(const Layer<Encoder>& layer, const Records& records)
{
  // The scanner channel, two bits of the flags, belongs to the plan layer.
  const unsigned mask = layer.field == field::flags ? 0xCFU : 0xFFU;
  for (std::size_t i = 1; i < records.count; ++i)
    for (std::size_t b = layer.place.at; b < layer.place.at + layer.size; ++b)
      if (((records.at(i)[b] ^ records.first[b]) & mask) != 0)
        return true;
  return false;
}

Bytes8
writeLayers(const Layout& layout, const Records& records)
{
  const std::vector<Layer<Encoder>> layers = layersOf<Encoder>(layout);
  std::vector<std::unique_ptr<LayerCoder<Encoder>>> coders;
  coders.reserve(layers.size());
  for (const Layer<Encoder>& layer : layers)
    coders.push_back(varies(layer, records)
                         ? layer.make(Encoder(), records.first, layer.place)
                         : nullptr);
  Encoder plan_coder;
  PlanLayer plan(records.first);
  for (std::size_t i = 1; i < records.count; ++i) {
    const Note note = plan.code(plan_coder, records.at(i));
    for (const auto& coder : coders)
      if (coder != nullptr)
        coder->code(records.at(i), note);
  }
  std::vector<Bytes8> streams = {plan_coder.finish()};
  for (const auto& coder : coders)
    streams.push_back(coder != nullptr ? coder->coder.finish() : Bytes8());

  Bytes8 out(4 + 4 * streams.size());
  store(out.data(), static_cast<std::uint32_t>(records.count));
  for (std::size_t i = 0; i < streams.size(); ++i)
    store(&out[4 + 4 * i], static_cast<std::uint32_t>(streams[i].size()));
  for (const Bytes8& stream : streams)
    append(out, stream);
  return out;
}

} // namespace

std::vector<std::uint8_t>
writeChunk(const Layout& layout, std::uint8_t* records, std::size_t count)
{
  const Records all = {records, layout.recordLength(), count};
  Bytes8 bytes(records, records + all.stride);
  append(bytes, layout.layered() ? writeLayers(layout, all) : writeItems(layout, all));
  return bytes;
}

} // namespace linelet::laz
