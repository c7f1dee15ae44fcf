// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

#include "bytes.h"
#include "decoder.h"
#include "integers.h"
#include "item_coder.h"

namespace linelet::laz {

/** \brief GPS times, version 1 (2010): multiples of the last step. */
class GpsTimeV1 : public ItemCoder<Decoder> {
public:
  explicit GpsTimeV1(const std::uint8_t* first) : time_(load<std::uint64_t>(first)) {}

  void
  code(Decoder& coder, std::uint8_t* at) override
  {
    if (step_ == 0) {
      const unsigned symbol = coder.symbol(still_);
      if (symbol == 1)
        advance(step_ = static_cast<std::int32_t>(steps_.code(coder, 0)));
      else if (symbol == 2)
        readWhole(coder);
    }
    else {
      const unsigned symbol = coder.symbol(multiple_);
      if (symbol < whole)
        advance(nextStep(coder, symbol));
      else if (symbol == whole)
        readWhole(coder);
    }
    store(at, time_);
  }

private:
  static constexpr unsigned whole = 510, most = 509;

  void
  advance(std::int32_t step)
  {
    time_ += static_cast<std::uint64_t>(std::int64_t{step});
  }

  void
  readWhole(Decoder& coder)
  {
    const std::uint64_t low = coder.word();
    time_ = std::uint64_t{coder.word()} << 32U | low;
  }

  std::int32_t
  nextStep(Decoder& coder, unsigned multiple)
  {
    const unsigned context = multiple == 1   ? 1
                             : multiple == 0 ? 2
                             : multiple < 10 ? 3
                             : multiple < 50 ? 4
                                             : 5;
    const std::uint32_t prediction = multiple == 0
                                         ? static_cast<std::uint32_t>(step_ / 4)
                                         : multiple * static_cast<std::uint32_t>(step_);
    const auto step =
        static_cast<std::int32_t>(steps_.code(coder, prediction, 0, context));
    const bool extreme = multiple == 0 || multiple == most;
    if (multiple == 1 || (extreme && ++extremes_ > 3)) {
      step_ = step;
      extremes_ = 0;
    }
    return step;
  }

  std::uint64_t time_;
  std::int32_t step_ = 0;
  unsigned extremes_ = 0;
  SymbolModel<3> still_;
  SymbolModel<512> multiple_;
  IntegerModel<32, 6> steps_;
};

} // namespace linelet::laz
