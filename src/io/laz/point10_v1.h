// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "bytes.h"
#include "decoder.h"
#include "integers.h"
#include "item_coder.h"
#include "model_bank.h"

namespace linelet::laz {

/** \brief The 20 bytes that point formats 0 to 5 begin with, version 1 (2010). */
class Point10V1 : public ItemCoder<Decoder> {
public:
  explicit Point10V1(const std::uint8_t* first)
  {
    std::copy_n(first, 20, last_.begin());
  }

  void
  code(Decoder& coder, std::uint8_t* at) override
  {
    std::uint8_t* last = last_.data();
    const std::int32_t x = step(coder, dx_, x_, 0);
    const std::int32_t y = step(coder, dy_, y_, std::min(dx_.size(), 19U));
    const unsigned size = (dx_.size() + dy_.size()) / 2;
    store(last, load<std::uint32_t>(last) + static_cast<std::uint32_t>(x));
    store(last + 4, load<std::uint32_t>(last + 4) + static_cast<std::uint32_t>(y));
    store(last + 8,
          z_.code(coder, load<std::uint32_t>(last + 8), 0, std::min(size, 19U)));
    place_ = (place_ + 1) % 3;

    const unsigned changed = coder.symbol(changed_);
    if ((changed & 32U) != 0)
      codeWord(coder, intensity_, last + 12);
    if ((changed & 16U) != 0)
      last[14] = static_cast<std::uint8_t>(coder.symbol(flags_[last[14]]));
    if ((changed & 8U) != 0)
      last[15] = static_cast<std::uint8_t>(coder.symbol(classes_[last[15]]));
    if ((changed & 4U) != 0)
      last[16] =
          static_cast<std::uint8_t>(angles_.code(coder, last[16], 0, size < 3 ? 1 : 0));
    if ((changed & 2U) != 0)
      last[17] = static_cast<std::uint8_t>(coder.symbol(users_[last[17]]));
    if ((changed & 1U) != 0)
      codeWord(coder, sources_, last + 18);
    std::copy(last_.begin(), last_.end(), at);
  }

private:
  using Steps = std::array<std::int32_t, 3>;

  template <class Model>
  std::int32_t
  step(Decoder& coder, Model& model, Steps& steps, unsigned context)
  {
    const std::int32_t low = std::min(steps[0], steps[1]);
    const std::int32_t high = std::max(steps[0], steps[1]);
    const std::int32_t median = std::max(low, std::min(high, steps[2]));
    const auto found = static_cast<std::int32_t>(
        model.code(coder, static_cast<std::uint32_t>(median), 0, context));
    steps[place_] = found;
    return found;
  }

  static void
  codeWord(Decoder& coder, IntegerModel<16>& model, std::uint8_t* at)
  {
    store(at, static_cast<std::uint16_t>(model.code(coder, load<std::uint16_t>(at))));
  }

  std::array<std::uint8_t, 20> last_{};
  Steps x_{}, y_{};
  unsigned place_ = 0; ///< of the next step
  SymbolModel<64> changed_;
  ModelBank<256, 256> flags_, classes_, users_;
  IntegerModel<32> dx_;
  IntegerModel<32, 20> dy_, z_;
  IntegerModel<16> intensity_, sources_;
  IntegerModel<8, 2> angles_;
};

} // namespace linelet::laz
