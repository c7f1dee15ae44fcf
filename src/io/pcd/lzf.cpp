// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lzf.h"

#include <cstddef>

namespace linelet::io {

// By hand: liblzf is within 5 % on coordinates, and would be one more dependency.
// A control byte below 32 says how many bytes, less one, follow as they are. Every
// other one is a copy of what was unpacked before: its upper three bits hold the length
// less two (7: a further byte adds to it), its lower five and the byte behind the
// distance less one.
bool
unpackLzf(std::string_view packed, std::string& out)
{
  std::size_t in = 0, done = 0;
  while (in < packed.size()) {
    const auto byte = [&](std::size_t i) {
      return static_cast<std::size_t>(static_cast<unsigned char>(packed[i]));
    };
    const std::size_t control = byte(in++);
    if (control < 32) {
      const std::size_t length = control + 1;
      if (length > packed.size() - in || length > out.size() - done)
        return false;
      packed.copy(&out[done], length, in);
      in += length;
      done += length;
      continue;
    }
    std::size_t length = (control >> 5) + 2;
    if (length == 9 && in < packed.size())
      length += byte(in++);
    if (in >= packed.size())
      return false;
    const std::size_t distance = ((control & 31U) << 8) + byte(in++) + 1;
    if (distance > done || length > out.size() - done)
      return false;
    for (; length > 0; --length, ++done) // may overlap itself
      out[done] = out[done - distance];
  }
  return done == out.size();
}

} // namespace linelet::io
