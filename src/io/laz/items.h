// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "bytes.h"
#include "colors.h"
#include "decoder.h"
#include "gps_time.h"
#include "integers.h"
#include "item_coder.h"
#include "wave_packets.h"

namespace linelet::laz {

/** \brief GPS times, version 2. */
template <class Coder>
class GpsTime11 : public ItemCoder<Coder> {
public:
  explicit GpsTime11(const std::uint8_t* first) : model_(load<std::uint64_t>(first)) {}

  void
  code(Coder& coder, std::uint8_t* at) override
  {
    store(at, model_.code(coder, load<std::uint64_t>(at)));
  }

private:
  GpsTimeModel<true> model_;
};

inline ColorModel::Color
loadColor(const std::uint8_t* at)
{
  return {load<std::uint16_t>(at),
          load<std::uint16_t>(at + 2),
          load<std::uint16_t>(at + 4)};
}

inline void
storeColor(std::uint8_t* at, const ColorModel::Color& color)
{
  for (std::size_t i = 0; i < 3; ++i)
    store(at + 2 * i, color[i]);
}

/** \brief Colors, version 2. */
template <class Coder>
class Rgb12 : public ItemCoder<Coder> {
public:
  explicit Rgb12(const std::uint8_t* first) : last_(loadColor(first)) {}

  void
  code(Coder& coder, std::uint8_t* at) override
  {
    last_ = model_.code(coder, last_, loadColor(at));
    storeColor(at, last_);
  }

private:
  ColorModel::Color last_;
  ColorModel model_;
};

/** \brief Colors, version 1 (2010): six independent bytes. */
class Rgb12V1 : public ItemCoder<Decoder> {
public:
  explicit Rgb12V1(const std::uint8_t* first) { std::copy_n(first, 6, last_); }

  void
  code(Decoder& coder, std::uint8_t* at) override
  {
    const unsigned used = coder.symbol(used_);
    for (unsigned i = 0; i < 6; ++i) {
      if ((used >> i & 1U) != 0)
        last_[i] = static_cast<std::uint8_t>(bytes_.code(coder, last_[i], 0, i));
      at[i] = last_[i];
    }
  }

private:
  std::uint8_t last_[6];
  SymbolModel<64> used_;
  IntegerModel<8, 6> bytes_;
};

/** \brief Waveform packets, of which there is only one version. */
template <class Coder>
class WavePacket13 : public ItemCoder<Coder> {
public:
  explicit WavePacket13(const std::uint8_t* first)
  {
    std::copy_n(first, wave_packet_size, last_.begin());
  }

  void
  code(Coder& coder, std::uint8_t* at) override
  {
    model_.code(coder, last_, at);
    std::copy_n(at, wave_packet_size, last_.begin());
  }

private:
  WavePacket last_{};
  WavePacketModel model_;
};

/** \brief Extra bytes, version 2. */
template <class Coder>
class Bytes : public ItemCoder<Coder> {
public:
  Bytes(const std::uint8_t* first, std::size_t size)
      : last_(first, first + size), models_(size)
  {
  }

  void
  code(Coder& coder, std::uint8_t* at) override
  {
    for (std::size_t i = 0; i < last_.size(); ++i) {
      const auto step = static_cast<std::uint8_t>(at[i] - last_[i]);
      at[i] = last_[i] =
          static_cast<std::uint8_t>(last_[i] + coder.symbol(models_[i], step));
    }
  }

private:
  std::vector<std::uint8_t> last_;
  std::vector<SymbolModel<256>> models_;
};

/** \brief Extra bytes, version 1 (2010). */
class BytesV1 : public ItemCoder<Decoder> {
public:
  BytesV1(const std::uint8_t* first, std::size_t size)
      : last_(first, first + size), model_(size)
  {
  }

  void
  code(Decoder& coder, std::uint8_t* at) override
  {
    for (std::size_t i = 0; i < last_.size(); ++i)
      at[i] = last_[i] = static_cast<std::uint8_t>(
          model_.code(coder, last_[i], 0, static_cast<unsigned>(i)));
  }

private:
  std::vector<std::uint8_t> last_;
  IntegerModel<8, 0> model_;
};

} // namespace linelet::laz
