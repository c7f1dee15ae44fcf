// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "bytes.h"
#include "integers.h"

namespace linelet::laz {

constexpr std::size_t wave_packet_size = 29;

/** \brief The fields of a point that locate its waveform, as stored in the file. */
using WavePacket = std::array<std::uint8_t, wave_packet_size>;

class WavePacketModel {
public:
  template <class Coder>
  void
  code(Coder& coder, const WavePacket& before, std::uint8_t* at)
  {
    at[0] = static_cast<std::uint8_t>(coder.symbol(descriptor_, at[0]));
    store(at + 1, codeOffset(coder, before, load<std::uint64_t>(at + 1)));
    const auto word = [&](auto& model, std::size_t place, unsigned context) {
      store(at + place,
            model.code(coder,
                       load<std::uint32_t>(&before[place]),
                       load<std::uint32_t>(at + place),
                       context));
    };
    word(sizes_, 9, 0);
    word(locations_, 13, 0);
    for (unsigned axis = 0; axis < 3; ++axis)
      word(directions_, 17 + 4 * axis, axis);
  }

private:
  enum Step : unsigned { same, behind, near, anywhere };

  template <class Coder>
  std::uint64_t
  codeOffset(Coder& coder, const WavePacket& before, std::uint64_t value)
  {
    const auto offset = load<std::uint64_t>(&before[1]);
    const auto size = load<std::uint32_t>(&before[9]);
    const std::uint64_t step = value - offset;
    if constexpr (Coder::encodes) {
      const auto number = static_cast<std::int64_t>(step);
      const bool fits = number == static_cast<std::int32_t>(number);
      step_ = coder.symbol(steps_[step_],
                           step == 0      ? same
                           : step == size ? behind
                           : fits         ? near
                                          : anywhere);
    }
    else
      step_ = coder.symbol(steps_[step_]);
    switch (step_) {
    case same:
      return offset;
    case behind:
      return offset + size;
    case near:
      last_step_ =
          near_steps_.code(coder, last_step_, static_cast<std::uint32_t>(step));
      return offset + static_cast<std::uint64_t>(
                          std::int64_t{static_cast<std::int32_t>(last_step_)});
    default:
      const std::uint64_t low = coder.word(static_cast<std::uint32_t>(value));
      return std::uint64_t{coder.word(static_cast<std::uint32_t>(value >> 32U))}
                 << 32U |
             low;
    }
  }

  SymbolModel<256> descriptor_;
  std::array<SymbolModel<4>, 4> steps_;
  unsigned step_ = same;
  std::uint32_t last_step_ = 0;
  IntegerModel<32> near_steps_, sizes_, locations_;
  IntegerModel<32, 3> directions_;
};

} // namespace linelet::laz
