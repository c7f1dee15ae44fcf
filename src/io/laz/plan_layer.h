// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "bytes.h"
#include "channels.h"
#include "integers.h"
#include "median.h"
#include "model_bank.h"
#include "return_maps.h"

namespace linelet::laz {

/** \brief The first layer of a chunk of point formats 6 to 10: scanner channel,
 * returns, x and y, and which of the other values change. */
class PlanLayer {
public:
  explicit PlanLayer(const std::uint8_t* first)
      : channels_(channelOf(first), Last(first))
  {
  }

  /** \brief Codes the point of the record \a at. */
  template <class Coder>
  Note
  code(Coder& coder, std::uint8_t* at)
  {
    const Last value(at);
    const unsigned wanted_channel = channelOf(at), channel = channels_.number();
    State& before = channels_.current();
    unsigned changed = 0;
    if constexpr (Coder::encodes)
      changed =
          changes(channels_.knows(wanted_channel) ? channels_.peek(wanted_channel).last
                                                  : before.last,
                  value) |
          (wanted_channel != channel ? channel_bit : 0U);
    const unsigned situation = (before.last.r == 1 ? 1U : 0U) +
                               (before.last.r >= before.last.n ? 2U : 0U) +
                               (before.last.new_time ? 4U : 0U);
    changed = coder.symbol(before.changed[situation], changed);
    Note note;
    if ((changed & channel_bit) != 0) {
      const unsigned step =
          coder.symbol(before.channel, (wanted_channel - channel - 1) & 3U);
      channels_.enter((channel + step + 1) & 3U);
      note.changed = Note::switch_bit;
    }
    State& state = channels_.current();
    note.changed = static_cast<std::uint8_t>(
        note.changed | ((changed & time_bit) != 0 ? Note::time_bit : 0) |
        ((changed & angle_bit) != 0 ? Note::angle_bit : 0) |
        ((changed & source_bit) != 0 ? Note::source_bit : 0));
    codeReturns(coder, state, changed, value);
    note.height = codePlace(coder, state, (changed & time_bit) != 0, value);
    if constexpr (Coder::encodes) {
      state.last.time = value.time;
      state.last.angle = value.angle;
      state.last.source = value.source;
    }
    else
      write(at, state.last);
    return note;
  }

private:
  struct Last {
    std::uint32_t x, y;
    unsigned r, n; ///< return r of n
    bool new_time = false;
    // Previous values for the encoder to compare with:
    std::uint64_t time;
    std::uint16_t angle, source;

    explicit Last(const std::uint8_t* at)
        : x(load<std::uint32_t>(at)),
          y(load<std::uint32_t>(at + 4)),
          r(at[returns_at] & 15U),
          n(at[returns_at] >> 4U),
          time(load<std::uint64_t>(at + time_at)),
          angle(load<std::uint16_t>(at + angle_at)),
          source(load<std::uint16_t>(at + source_at))
    {
    }
  };

  struct State {
    explicit State(const Last& begin) : last(begin) { last.new_time = false; }

    Last last;
    std::array<SymbolModel<128>, 8> changed;
    SymbolModel<3> channel;
    ModelBank<16, 16> returns, number;
    SymbolModel<13> number_at_same_time;
    IntegerModel<32, 2> dx;
    IntegerModel<32, 22> dy;
    std::array<RunningMedian, 12> steps_x, steps_y;
  };

  // Bits of the symbol for what changes; the two lowest are the step of the return:
  // none, one up, one down, other.
  enum Bit : unsigned {
    n_bit = 4,
    angle_bit = 8,
    time_bit = 16,
    source_bit = 32,
    channel_bit = 64
  };
  enum Step : unsigned { same = 0, up = 1, down = 2, other = 3 };

  static unsigned
  changes(const Last& last, const Last& value)
  {
    const unsigned step = (value.r - last.r) & 15U;
    return (step == 0    ? same
            : step == 1  ? up
            : step == 15 ? down
                         : other) |
           (value.n != last.n ? n_bit : 0U) |
           (value.angle != last.angle ? angle_bit : 0U) |
           (value.time != last.time ? time_bit : 0U) |
           (value.source != last.source ? source_bit : 0U);
  }

  template <class Coder>
  static void
  codeReturns(Coder& coder, State& state, unsigned changed, const Last& value)
  {
    Last& last = state.last;
    if ((changed & n_bit) != 0)
      last.n = coder.symbol(state.returns[last.n], value.n);
    switch (changed & 3U) {
    case same:
      break;
    case up:
      last.r = (last.r + 1) & 15U;
      break;
    case down:
      last.r = (last.r - 1) & 15U;
      break;
    default:
      if ((changed & time_bit) != 0)
        last.r = coder.symbol(state.number[last.r], value.r);
      else
        last.r =
            (last.r + 2 +
             coder.symbol(state.number_at_same_time, (value.r - last.r - 2) & 15U)) &
            15U;
    }
  }

  /** Codes x and y; returns the context of the height. */
  template <class Coder>
  static std::uint8_t
  codePlace(Coder& coder, State& state, bool new_time, const Last& value)
  {
    Last& last = state.last;
    const unsigned map = 2U * layered_return_map[last.n][last.r] + (new_time ? 1U : 0U);
    const unsigned single = last.n == 1 ? 1 : 0;
    const auto codeStep = [&coder](auto& model,
                                   RunningMedian& steps,
                                   std::uint32_t& at,
                                   std::uint32_t wanted,
                                   unsigned context) {
      const std::uint32_t step = model.code(
          coder, static_cast<std::uint32_t>(steps.get()), wanted - at, context);
      steps.add(static_cast<std::int32_t>(step));
      at += step;
    };
    codeStep(state.dx, state.steps_x[map], last.x, value.x, single);
    const unsigned x_size = std::min(state.dx.size() & ~1U, 20U);
    codeStep(state.dy, state.steps_y[map], last.y, value.y, single + x_size);
    last.new_time = new_time;
    const unsigned size = std::min((state.dx.size() + state.dy.size()) / 2 & ~1U, 18U);
    return static_cast<std::uint8_t>(single + size);
  }

  void
  write(std::uint8_t* at, const Last& last) const
  {
    store(at, last.x);
    store(at + 4, last.y);
    at[returns_at] = static_cast<std::uint8_t>(last.n << 4U | last.r);
    at[flags_at] =
        static_cast<std::uint8_t>((at[flags_at] & 0xCFU) | channels_.number() << 4U);
  }

  Channels<State> channels_;
};

} // namespace linelet::laz
