// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace linelet::laz {

// Of a record of point formats 6 to 10.
constexpr std::size_t returns_at = 14, flags_at = 15, classification_at = 16,
                      user_data_at = 17, angle_at = 18, source_at = 20, time_at = 22;

inline unsigned
channelOf(const std::uint8_t* record)
{
  return record[flags_at] >> 4U & 3U;
}

/** \brief What the first layer of a chunk states about a point besides its record. */
struct Note {
  enum Bit : std::uint8_t {
    time_bit = 1,
    angle_bit = 2,
    source_bit = 4,
    switch_bit = 8
  };
  std::uint8_t changed = 0; ///< which values change, and whether the channel does
  std::uint8_t height = 0;  ///< context of the height
};

/** \brief The states of a layer, one per scanner channel. A channel that appears for
 * the first time starts with the last values of the previous one.
 *
 * State has a member `Last last` and a constructor from it. */
template <class State>
class Channels {
public:
  template <class Last>
  Channels(unsigned first, const Last& last) : current_(first)
  {
    states_[first] = std::make_unique<State>(last);
  }

  State&
  current()
  {
    return *states_[current_];
  }

  State&
  enter(unsigned channel)
  {
    if (channel != current_) {
      if (states_[channel] == nullptr)
        states_[channel] = std::make_unique<State>(states_[current_]->last);
      current_ = channel;
    }
    return *states_[current_];
  }

  bool
  knows(unsigned channel) const
  {
    return states_[channel] != nullptr;
  }

  /** \brief State of a known channel. */
  const State&
  peek(unsigned channel) const
  {
    return *states_[channel];
  }

  unsigned
  number() const
  {
    return current_;
  }

private:
  std::array<std::unique_ptr<State>, 4> states_;
  unsigned current_;
};

/** \brief The channels of the layers after those of the point itself. Version 4 works
 * like \ref Channels, version 3 too except for two flaws that are part of the format.
 */
template <class State>
class ItemChannels {
public:
  template <class Last>
  ItemChannels(unsigned first, const Last& last, bool version4)
      : channels_(first, last), version4_(version4)
  {
  }

  struct Place {
    State& models;
    decltype(State::last)& last; ///< values to predict from and to update
  };

  /** \brief State for the point of \a record and \a note. */
  Place
  enter(const std::uint8_t* record, const Note& note)
  {
    // Version 3 notices a channel only when it switches, and assumes 0 otherwise.
    const bool told = version4_ || (note.changed & Note::switch_bit) != 0;
    const unsigned channel = told ? channelOf(record) : 0;
    if (channel == channels_.number())
      return {channels_.current(), channels_.current().last};
    // If the new channel is already known, version 3 still predicts from the old one.
    State& before = channels_.current();
    const bool stale = !version4_ && channels_.knows(channel);
    State& now = channels_.enter(channel);
    return {now, stale ? before.last : now.last};
  }

private:
  Channels<State> channels_;
  bool version4_;
};

} // namespace linelet::laz
