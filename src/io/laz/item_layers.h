// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "bytes.h"
#include "channels.h"
#include "colors.h"
#include "items.h"
#include "wave_packets.h"

namespace linelet::laz {

/** \brief Where the field of an item layer lies, and its version. */
struct ItemPlace {
  std::size_t at; ///< byte of the record
  bool version4;
};

class ColorLayer {
public:
  ColorLayer(const std::uint8_t* first, ItemPlace place)
      : at_(place.at),
        channels_(channelOf(first), loadColor(first + place.at), place.version4)
  {
  }

  template <class Coder>
  void
  code(Coder& coder, std::uint8_t* at, Note note)
  {
    const auto state = channels_.enter(at, note);
    state.last = state.models.model.code(coder, state.last, loadColor(at + at_));
    storeColor(at + at_, state.last);
  }

private:
  struct State {
    explicit State(const ColorModel::Color& begin) : last(begin) {}
    ColorModel::Color last;
    ColorModel model;
  };

  std::size_t at_; ///< byte of the record
  ItemChannels<State> channels_;
};

/** \brief Near infrared. */
class NirLayer {
public:
  NirLayer(const std::uint8_t* first, ItemPlace place)
      : at_(place.at),
        channels_(
            channelOf(first), load<std::uint16_t>(first + place.at), place.version4)
  {
  }

  template <class Coder>
  void
  code(Coder& coder, std::uint8_t* record, Note note)
  {
    std::uint8_t* at = record + at_;
    const auto state = channels_.enter(record, note);
    const unsigned value = load<std::uint16_t>(at), last = state.last;
    unsigned used = 0;
    if constexpr (Coder::encodes)
      used = ((value ^ last) & 0xFFU ? 1U : 0U) | ((value ^ last) >> 8U ? 2U : 0U);
    used = coder.symbol(state.models.used, used);
    unsigned bytes[2] = {last & 0xFFU, last >> 8U};
    for (unsigned high = 0; high < 2; ++high)
      if ((used >> high & 1U) != 0)
        bytes[high] =
            (bytes[high] + coder.symbol(state.models.steps[high],
                                        ((value >> 8 * high) - bytes[high]) & 0xFFU)) &
            0xFFU;
    state.last = static_cast<std::uint16_t>(bytes[1] << 8U | bytes[0]);
    store(at, state.last);
  }

private:
  struct State {
    explicit State(std::uint16_t begin) : last(begin) {}
    std::uint16_t last;
    SymbolModel<4> used;
    std::array<SymbolModel<256>, 2> steps;
  };

  std::size_t at_; ///< byte of the record
  ItemChannels<State> channels_;
};

class WavePacketLayer {
public:
  WavePacketLayer(const std::uint8_t* first, ItemPlace place)
      : at_(place.at),
        channels_(channelOf(first), loadPacket(first + place.at), place.version4)
  {
  }

  template <class Coder>
  void
  code(Coder& coder, std::uint8_t* record, Note note)
  {
    std::uint8_t* at = record + at_;
    const auto state = channels_.enter(record, note);
    state.models.model.code(coder, state.last, at);
    std::copy_n(at, wave_packet_size, state.last.begin());
  }

private:
  static WavePacket
  loadPacket(const std::uint8_t* at)
  {
    WavePacket packet;
    std::copy_n(at, packet.size(), packet.begin());
    return packet;
  }

  struct State {
    explicit State(const WavePacket& begin) : last(begin) {}
    WavePacket last;
    WavePacketModel model;
  };

  std::size_t at_; ///< byte of the record
  ItemChannels<State> channels_;
};

/** \brief One of the extra bytes. */
class ExtraByteLayer {
public:
  ExtraByteLayer(const std::uint8_t* first, ItemPlace place)
      : at_(place.at), channels_(channelOf(first), first[place.at], place.version4)
  {
  }

  template <class Coder>
  void
  code(Coder& coder, std::uint8_t* record, Note note)
  {
    std::uint8_t* at = record + at_;
    const auto state = channels_.enter(record, note);
    const auto step = static_cast<std::uint8_t>(*at - state.last);
    *at = state.last =
        static_cast<std::uint8_t>(state.last + coder.symbol(state.models.model, step));
  }

private:
  struct State {
    explicit State(std::uint8_t begin) : last(begin) {}
    std::uint8_t last;
    SymbolModel<256> model;
  };

  std::size_t at_; ///< byte of the record
  ItemChannels<State> channels_;
};

} // namespace linelet::laz
