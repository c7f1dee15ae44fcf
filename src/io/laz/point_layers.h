// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "bytes.h"
#include "channels.h"
#include "gps_time.h"
#include "integers.h"
#include "model_bank.h"

namespace linelet::laz {

// The other layers of point formats 6 to 10, one field each. Their code() gets the
// record of a point whose channel and returns the plan layer has already coded.

/** \brief First (2) and last (1) return, or both, or neither. */
inline unsigned
returnKind(const std::uint8_t* record)
{
  const unsigned r = record[returns_at] & 15U, n = record[returns_at] >> 4U;
  return (r == 1 ? 2U : 0U) + (r >= n ? 1U : 0U);
}

class HeightLayer {
public:
  explicit HeightLayer(const std::uint8_t* first)
      : channels_(channelOf(first), load<std::uint32_t>(first + 8))
  {
  }

  template <class Coder>
  void
  code(Coder& coder, std::uint8_t* at, Note note)
  {
    State& state = channels_.enter(channelOf(at));
    const unsigned r = at[returns_at] & 15U, n = at[returns_at] >> 4U;
    std::uint32_t& height = state.heights[std::min(n > r ? n - r : r - n, 7U)];
    height = state.last =
        state.model.code(coder, height, load<std::uint32_t>(at + 8), note.height);
    store(at + 8, height);
  }

private:
  struct State {
    explicit State(std::uint32_t begin) : last(begin) { heights.fill(begin); }
    std::uint32_t last;
    std::array<std::uint32_t, 8> heights{};
    IntegerModel<32, 20> model;
  };

  Channels<State> channels_;
};

/** \brief A layer of one byte, or some of its bits, coded with a bank of \a Situations
 * models. Field defines how the byte is read, written and predicted. */
template <class Field, unsigned Situations, unsigned Symbols>
class ByteLayer {
public:
  explicit ByteLayer(const std::uint8_t* first)
      : channels_(channelOf(first), Field::get(first))
  {
  }

  template <class Coder>
  void
  code(Coder& coder, std::uint8_t* at, Note /*note*/)
  {
    State& state = channels_.enter(channelOf(at));
    state.last =
        coder.symbol(state.models[Field::situation(at, state.last)], Field::get(at));
    Field::put(at, state.last);
  }

private:
  struct State {
    explicit State(unsigned begin) : last(begin) {}
    unsigned last;
    ModelBank<Situations, Symbols> models;
  };

  Channels<State> channels_;
};

struct ClassificationField {
  static unsigned
  get(const std::uint8_t* at)
  {
    return at[classification_at];
  }
  static void
  put(std::uint8_t* at, unsigned value)
  {
    at[classification_at] = static_cast<std::uint8_t>(value);
  }
  static unsigned
  situation(const std::uint8_t* at, unsigned last)
  {
    return (last & 31U) * 2 + (returnKind(at) == 3 ? 1U : 0U);
  }
};

/** \brief The byte of the flags without the channel. */
struct FlagsField {
  static unsigned
  get(const std::uint8_t* at)
  {
    return (at[flags_at] & 15U) | (at[flags_at] >> 2U & 0x30U);
  }
  static void
  put(std::uint8_t* at, unsigned value)
  {
    at[flags_at] = static_cast<std::uint8_t>((at[flags_at] & 0x30U) | (value & 15U) |
                                             (value & 0x30U) << 2U);
  }
  static unsigned
  situation(const std::uint8_t*, unsigned last)
  {
    return last;
  }
};

struct UserDataField {
  static unsigned
  get(const std::uint8_t* at)
  {
    return at[user_data_at];
  }
  static void
  put(std::uint8_t* at, unsigned value)
  {
    at[user_data_at] = static_cast<std::uint8_t>(value);
  }
  static unsigned
  situation(const std::uint8_t*, unsigned last)
  {
    return last / 4;
  }
};

using ClassificationLayer = ByteLayer<ClassificationField, 64, 256>;
using FlagsLayer = ByteLayer<FlagsField, 64, 64>;
using UserDataLayer = ByteLayer<UserDataField, 64, 256>;

class IntensityLayer {
public:
  explicit IntensityLayer(const std::uint8_t* first)
      : channels_(channelOf(first), load<std::uint16_t>(first + place))
  {
  }

  template <class Coder>
  void
  code(Coder& coder, std::uint8_t* at, Note note)
  {
    State& state = channels_.enter(channelOf(at));
    const unsigned kind = returnKind(at);
    std::uint16_t& value = state.values[2 * kind + (note.changed & Note::time_bit)];
    value = state.last = static_cast<std::uint16_t>(
        state.model.code(coder, value, load<std::uint16_t>(at + place), kind));
    store(at + place, value);
  }

private:
  static constexpr std::size_t place = 12;
  struct State {
    explicit State(std::uint16_t begin) : last(begin) { values.fill(begin); }
    std::uint16_t last;
    std::array<std::uint16_t, 8> values{};
    IntegerModel<16, 4> model;
  };

  Channels<State> channels_;
};

/** \brief A 16-bit number at byte \a Place, coded if \a Bit of the note marks a change;
 * with \a Timed, in two contexts. */
template <std::size_t Place, Note::Bit Bit, bool Timed>
class WordLayer {
public:
  explicit WordLayer(const std::uint8_t* first)
      : channels_(channelOf(first), load<std::uint16_t>(first + Place))
  {
  }

  template <class Coder>
  void
  code(Coder& coder, std::uint8_t* at, Note note)
  {
    State& state = channels_.enter(channelOf(at));
    const unsigned situation = Timed ? note.changed & Note::time_bit : 0;
    if ((note.changed & Bit) != 0)
      state.last = static_cast<std::uint16_t>(state.model.code(
          coder, state.last, load<std::uint16_t>(at + Place), situation));
    store(at + Place, state.last);
  }

private:
  struct State {
    explicit State(std::uint16_t begin) : last(begin) {}
    std::uint16_t last;
    IntegerModel<16, Timed ? 2 : 1> model;
  };

  Channels<State> channels_;
};

using AngleLayer = WordLayer<angle_at, Note::angle_bit, true>;
using SourceLayer = WordLayer<source_at, Note::source_bit, false>;

class TimeLayer {
public:
  explicit TimeLayer(const std::uint8_t* first)
      : channels_(channelOf(first), load<std::uint64_t>(first + time_at))
  {
  }

  template <class Coder>
  void
  code(Coder& coder, std::uint8_t* at, Note note)
  {
    State& state = channels_.enter(channelOf(at));
    if ((note.changed & Note::time_bit) != 0)
      state.last = state.model.code(coder, load<std::uint64_t>(at + time_at));
    store(at + time_at, state.last);
  }

private:
  struct State {
    explicit State(std::uint64_t begin) : last(begin), model(begin) {}
    std::uint64_t last;
    GpsTimeModel<false> model;
  };

  Channels<State> channels_;
};

} // namespace linelet::laz
