// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "channels.h"
#include "fields.h"
#include "item_layers.h"
#include "layout.h"
#include "plan_layer.h"
#include "point_layers.h"

namespace linelet::laz {

/** \brief Codes a layer in its own stream. All layers are coded point by point,
 * interleaved: a single stream would have to wait for every division. */
template <class Coder>
class LayerCoder {
public:
  explicit LayerCoder(Coder coder) : coder(std::move(coder)) {}
  virtual ~LayerCoder() = default;

  /** \brief Codes the field of the record at \a at of a point with \a note. */
  virtual void
  code(std::uint8_t* at, Note note) = 0;

  Coder coder;
};

/** \brief What a layer holds, and how it is coded. */
template <class Coder>
struct Layer {
  using Make = std::unique_ptr<LayerCoder<Coder>> (*)(Coder,
                                                      const std::uint8_t*,
                                                      ItemPlace);
  Fields field;
  ItemPlace place;
  std::size_t size; ///< of the field in the record
  Make make;        ///< gets the first record
};

namespace detail {

template <class Model, class Coder>
class CoderOf : public LayerCoder<Coder> {
public:
  template <class... Arguments>
  explicit CoderOf(Coder coder, Arguments... arguments)
      : LayerCoder<Coder>(std::move(coder)), model_(arguments...)
  {
  }

  void
  code(std::uint8_t* at, Note note) override
  {
    model_.code(this->coder, at, note);
  }

private:
  Model model_;
};

template <class Model, class Coder>
std::unique_ptr<LayerCoder<Coder>>
ofPoint(Coder coder, const std::uint8_t* first, ItemPlace)
{
  return std::make_unique<CoderOf<Model, Coder>>(std::move(coder), first);
}

template <class Model, class Coder>
std::unique_ptr<LayerCoder<Coder>>
ofItem(Coder coder, const std::uint8_t* first, ItemPlace place)
{
  return std::make_unique<CoderOf<Model, Coder>>(std::move(coder), first, place);
}

} // namespace detail

/** \brief The layers of \a layout after the plan layer, in file order. */
template <class Coder>
std::vector<Layer<Coder>>
layersOf(const Layout& layout)
{
  using namespace detail;
  std::vector<Layer<Coder>> layers = {
      {field::z, {8, false}, 4, ofPoint<HeightLayer, Coder>},
      {field::classification,
       {classification_at, false},
       1,
       ofPoint<ClassificationLayer, Coder>},
      {field::flags, {flags_at, false}, 1, ofPoint<FlagsLayer, Coder>},
      {field::intensity, {12, false}, 2, ofPoint<IntensityLayer, Coder>},
      {field::scan_angle, {angle_at, false}, 2, ofPoint<AngleLayer, Coder>},
      {field::user_data, {user_data_at, false}, 1, ofPoint<UserDataLayer, Coder>},
      {field::point_source, {source_at, false}, 2, ofPoint<SourceLayer, Coder>},
      {field::gps_time, {time_at, false}, 8, ofPoint<TimeLayer, Coder>}};
  std::size_t at = 0;
  for (const Item& item : layout.items) {
    const ItemPlace place = {at, item.version == 4};
    if (item.type == Item::Rgb14 || item.type == Item::RgbNir14)
      layers.push_back({field::color, place, 6, ofItem<ColorLayer, Coder>});
    if (item.type == Item::RgbNir14)
      layers.push_back(
          {field::nir, {at + 6, place.version4}, 2, ofItem<NirLayer, Coder>});
    if (item.type == Item::WavePacket14)
      layers.push_back({field::wave_packet,
                        place,
                        wave_packet_size,
                        ofItem<WavePacketLayer, Coder>});
    if (item.type == Item::Byte14)
      for (std::size_t i = 0; i < item.size; ++i)
        layers.push_back({field::extra_bytes,
                          {at + i, place.version4},
                          1,
                          ofItem<ExtraByteLayer, Coder>});
    at += item.size;
  }
  return layers;
}

} // namespace linelet::laz
