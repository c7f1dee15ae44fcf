// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <linelet/powerline/power_line_network.h>

namespace linelet::powerline {

/** \brief Finds the same wire as seen in another part: completely or not, and with
 * different noise. */
class WireIndex {
public:
  static constexpr int none = -1;

  /** \return the number of the wire, starting at 0 */
  int
  add(const Wire& wire);

  /** \brief The nearest of the wires that \a wire lies on. */
  int
  find(const Wire& wire) const;

  const Wire&
  operator[](int number) const
  {
    return wires_[static_cast<std::size_t>(number)];
  }

private:
  using Cell = std::pair<std::int64_t, std::int64_t>;

  static Cell
  cellOf(const Point& p);

  std::vector<Wire> wires_;
  std::map<Cell, std::vector<int>> cells_;
};

/** \brief The middle of a wire; the part that owns it owns the wire. */
inline Point
middleOf(const Wire& wire)
{
  return wire.curve.at((wire.curve.from + wire.curve.to) / 2);
}

} // namespace linelet::powerline
