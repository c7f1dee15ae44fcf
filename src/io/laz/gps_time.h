// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "integers.h"

namespace linelet::laz {

/** \brief Codes GPS times, as the bits of doubles, by up to four sequences of nearly
 * even steps. \a Repeats: whether "same as before" has its own symbol (version 2) or is
 * coded elsewhere (versions 3 and 4). */
template <bool Repeats>
class GpsTimeModel {
public:
  explicit GpsTimeModel(std::uint64_t first) { sequences_[0].time = first; }

  template <class Coder>
  std::uint64_t
  code(Coder& coder, std::uint64_t value = 0)
  {
    // A switch of the sequence is followed by another symbol. The loop ends even past
    // the end of the data: it reads as zeros, which never decode as a switch.
    for (;;) {
      Sequence& s = sequences_[current_];
      const bool still = s.step == 0;
      unsigned symbol = 0;
      if constexpr (Coder::encodes)
        symbol = still ? chooseStill(value) : chooseMultiple(value);
      symbol = still ? coder.symbol(still_, symbol) : coder.symbol(multiple_, symbol);
      const unsigned full = still ? still_full : multiple_full;
      if (Repeats && symbol == (still ? 0 : most - least + 1))
        return s.time;
      if (symbol > full) {
        current_ = (current_ + symbol - full) % 4;
        continue;
      }
      if (symbol == full)
        return begin(coder, value);
      const auto wanted = static_cast<std::uint32_t>(value - s.time);
      const auto step =
          still ? firstStep(coder, wanted) : nextStep(coder, symbol, wanted);
      s.time += static_cast<std::uint64_t>(static_cast<std::int64_t>(step));
      return s.time;
    }
  }

private:
  struct Sequence {
    std::uint64_t time = 0;
    std::int32_t step = 0;
    unsigned extremes = 0; ///< consecutive steps that are not a multiple of \a step
  };

  static constexpr int most = 500, least = -10; // multiples of the step
  static constexpr unsigned still_full = Repeats ? 2 : 1;
  static constexpr unsigned multiple_full = most - least + (Repeats ? 2 : 1);

  static bool
  fits(std::uint64_t step)
  {
    const auto number = static_cast<std::int64_t>(step);
    return number == static_cast<std::int32_t>(number);
  }

  /** A sequence that \a value is close to; otherwise starts a new one. */
  unsigned
  chooseOther(std::uint64_t value, unsigned full) const
  {
    for (unsigned i = 1; i < 4; ++i)
      if (fits(value - sequences_[(current_ + i) % 4].time))
        return full + i;
    return full;
  }

  unsigned
  chooseStill(std::uint64_t value) const
  {
    const std::uint64_t step = value - sequences_[current_].time;
    if (Repeats && step == 0)
      return 0;
    return fits(step) ? still_full - 1 : chooseOther(value, still_full);
  }

  unsigned
  chooseMultiple(std::uint64_t value) const
  {
    const Sequence& s = sequences_[current_];
    const std::uint64_t step = value - s.time;
    if (Repeats && step == 0)
      return most - least + 1;
    if (!fits(step))
      return chooseOther(value, multiple_full);
    const auto multiple = static_cast<int>(
        std::lround(static_cast<double>(static_cast<std::int32_t>(step)) / s.step));
    if (multiple >= 0)
      return static_cast<unsigned>(std::min(multiple, most));
    return static_cast<unsigned>(most - std::max(multiple, least));
  }

  template <class Coder>
  std::int32_t
  firstStep(Coder& coder, std::uint32_t wanted)
  {
    Sequence& s = sequences_[current_];
    s.step = static_cast<std::int32_t>(steps_.code(coder, 0, wanted, 0));
    s.extremes = 0;
    return s.step;
  }

  template <class Coder>
  std::int32_t
  nextStep(Coder& coder, unsigned symbol, std::uint32_t wanted)
  {
    Sequence& s = sequences_[current_];
    const int number = static_cast<int>(symbol);
    const int multiple = number <= most ? number : most - number;
    const unsigned context = multiple == 1       ? 1
                             : multiple == 0     ? 7
                             : multiple == most  ? 4
                             : multiple == least ? 6
                             : multiple < 0      ? 5
                             : multiple < 10     ? 2
                                                 : 3;
    const std::uint32_t prediction =
        static_cast<std::uint32_t>(multiple) * static_cast<std::uint32_t>(s.step);
    const auto step =
        static_cast<std::int32_t>(steps_.code(coder, prediction, wanted, context));
    if (multiple == 1)
      s.extremes = 0;
    else if ((multiple == 0 || multiple == most || multiple == least) &&
             ++s.extremes > 3) {
      s.step = step;
      s.extremes = 0;
    }
    return step;
  }

  template <class Coder>
  std::uint64_t
  begin(Coder& coder, std::uint64_t value)
  {
    const auto upper = static_cast<std::uint32_t>(sequences_[current_].time >> 32U);
    const std::uint32_t high =
        steps_.code(coder, upper, static_cast<std::uint32_t>(value >> 32U), 8);
    const std::uint32_t low = coder.word(static_cast<std::uint32_t>(value));
    current_ = newest_ = (newest_ + 1) % 4;
    sequences_[current_] = {std::uint64_t{high} << 32U | low, 0, 0};
    return sequences_[current_].time;
  }

  std::array<Sequence, 4> sequences_;
  unsigned current_ = 0, newest_ = 0;
  SymbolModel<still_full + 4> still_;
  SymbolModel<multiple_full + 4> multiple_;
  IntegerModel<32, 9> steps_;
};

} // namespace linelet::laz
