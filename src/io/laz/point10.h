// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

#include "bytes.h"
#include "integers.h"
#include "item_coder.h"
#include "median.h"
#include "model_bank.h"
#include "return_maps.h"

namespace linelet::laz {

/** \brief The 20 bytes that point formats 0 to 5 begin with, version 2. */
template <class Coder>
class Point10 : public ItemCoder<Coder> {
public:
  explicit Point10(const std::uint8_t* first) : last_(first) {}

  void
  code(Coder& coder, std::uint8_t* at) override
  {
    unsigned changed = 0;
    const Fields value(at);
    if constexpr (Coder::encodes)
      changed = changes(value);
    changed = coder.symbol(changed_, changed);
    if ((changed & flags_bit) != 0)
      last_.flags = byte(coder, flags_[last_.flags], value.flags);
    const unsigned n = last_.returns(), r = last_.number();
    const unsigned situation = return_map[n][r];
    codeAttributes(coder, changed, value, situation);
    codePlace(coder, value, situation, n, r);
    last_.write(at);
  }

private:
  struct Fields {
    std::uint32_t x, y, z;
    std::uint16_t intensity, source;
    std::uint8_t flags, classification, angle, user;

    explicit Fields(const std::uint8_t* at)
        : x(load<std::uint32_t>(at)),
          y(load<std::uint32_t>(at + 4)),
          z(load<std::uint32_t>(at + 8)),
          intensity(load<std::uint16_t>(at + 12)),
          source(load<std::uint16_t>(at + 18)),
          flags(at[14]),
          classification(at[15]),
          angle(at[16]),
          user(at[17])
    {
    }

    void
    write(std::uint8_t* at) const
    {
      store(at, x);
      store(at + 4, y);
      store(at + 8, z);
      store(at + 12, intensity);
      at[14] = flags;
      at[15] = classification;
      at[16] = angle;
      at[17] = user;
      store(at + 18, source);
    }

    unsigned
    number() const
    {
      return flags & 7U;
    }
    unsigned
    returns() const
    {
      return flags >> 3U & 7U;
    }
  };

  enum Bit : unsigned {
    source_bit = 1,
    user_bit = 2,
    angle_bit = 4,
    class_bit = 8,
    intensity_bit = 16,
    flags_bit = 32
  };

  template <unsigned N>
  static std::uint8_t
  byte(Coder& coder, SymbolModel<N>& model, std::uint8_t value)
  {
    return static_cast<std::uint8_t>(coder.symbol(model, value));
  }

  unsigned
  changes(const Fields& value) const
  {
    const unsigned situation = return_map[value.returns()][value.number()];
    return (value.source != last_.source ? source_bit : 0U) |
           (value.user != last_.user ? user_bit : 0U) |
           (value.angle != last_.angle ? angle_bit : 0U) |
           (value.classification != last_.classification ? class_bit : 0U) |
           (value.intensity != intensities_[situation] ? intensity_bit : 0U) |
           (value.flags != last_.flags ? flags_bit : 0U);
  }

  void
  codeAttributes(Coder& coder,
                 unsigned changed,
                 const Fields& value,
                 unsigned situation)
  {
    if ((changed & intensity_bit) != 0)
      intensities_[situation] = static_cast<std::uint16_t>(intensity_.code(
          coder, intensities_[situation], value.intensity, std::min(situation, 3U)));
    last_.intensity = intensities_[situation];
    if ((changed & class_bit) != 0)
      last_.classification =
          byte(coder, classes_[last_.classification], value.classification);
    if ((changed & angle_bit) != 0) {
      const auto step = static_cast<std::uint8_t>(value.angle - last_.angle);
      const unsigned direction = last_.flags >> 6U & 1U;
      last_.angle = static_cast<std::uint8_t>(last_.angle +
                                              byte(coder, angles_[direction], step));
    }
    if ((changed & user_bit) != 0)
      last_.user = byte(coder, users_[last_.user], value.user);
    if ((changed & source_bit) != 0)
      last_.source =
          static_cast<std::uint16_t>(sources_.code(coder, last_.source, value.source));
  }

  void
  codePlace(
      Coder& coder, const Fields& value, unsigned situation, unsigned n, unsigned r)
  {
    const unsigned single = n == 1 ? 1 : 0;
    const auto codeStep = [&](auto& model,
                              RunningMedian& steps,
                              std::uint32_t& last,
                              std::uint32_t wanted,
                              unsigned context) {
      const std::uint32_t step = model.code(
          coder, static_cast<std::uint32_t>(steps.get()), wanted - last, context);
      steps.add(static_cast<std::int32_t>(step));
      last += step;
    };
    codeStep(dx_, steps_x_[situation], last_.x, value.x, single);
    const unsigned x_size = std::min(dx_.size() & ~1U, 20U);
    codeStep(dy_, steps_y_[situation], last_.y, value.y, single + x_size);
    const unsigned size = std::min((dx_.size() + dy_.size()) / 2 & ~1U, 18U);
    const unsigned level = n > r ? n - r : r - n;
    last_.z = heights_[level] = z_.code(coder, heights_[level], value.z, single + size);
  }

  Fields last_;
  std::array<std::uint16_t, 16> intensities_{};
  std::array<std::uint32_t, 8> heights_{};
  std::array<RunningMedian, 16> steps_x_, steps_y_;
  SymbolModel<64> changed_;
  ModelBank<256, 256> flags_, classes_, users_;
  std::array<SymbolModel<256>, 2> angles_;
  IntegerModel<16, 4> intensity_;
  IntegerModel<16> sources_;
  IntegerModel<32, 2> dx_;
  IntegerModel<32, 22> dy_;
  IntegerModel<32, 20> z_;
};

} // namespace linelet::laz
