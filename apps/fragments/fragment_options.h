// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <string_view>

namespace linelet::apps {

/** \brief An amount of memory as text: "8G", "500M", "2e9"; "auto" is half of the
 * machine's. */
class MemorySize {
public:
  /** \throws std::invalid_argument */
  explicit MemorySize(std::string_view text);

  const std::string&
  name() const
  {
    return text_;
  }

  double
  bytes() const
  {
    return bytes_;
  }

private:
  std::string text_;
  double bytes_;
};

/** \brief How to divide a cloud that does not fit into memory. */
struct FragmentOptions {
  double chunk = 0;
  MemorySize memory{"auto"};
  bool resume = false;
};

template <class Visit>
void
describe(FragmentOptions& s, Visit&& visit)
{
  visit("memory",
        s.memory,
        "Fragments: process LAS and LAZ that need more memory than this in fragments, "
        "with the same result: 8G, 500M; auto: half of the machine's");
  visit("chunk",
        s.chunk,
        "Fragments: side of the fragments, in the unit of the cloud; they are then "
        "always used; 0: as wide as --memory allows");
  visit(
      "resume", s.resume, "Fragments: continue an interrupted run of the same command");
}

} // namespace linelet::apps
