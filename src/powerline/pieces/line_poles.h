// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "powerline/pieces/growth.h"
#include "powerline/pieces/profile.h"
#include "powerline/pieces/span_model.h"

namespace linelet::powerline {

constexpr double around_wire = 0.35; ///< meters, within which points may be its own

/** \brief Where poles stand along a line.
 *
 * Its parallel wires are examined together: at a pole all of them have a kink, though
 * in a dip of the terrain none shows it clearly on its own; and a pole is something
 * thin that reaches up to a wire. */
class LinePoles {
public:
  LinePoles(const std::vector<const Piece*>& wires, const Growth& growth);

  /** \brief Positions of the poles along \a model, ascending. */
  std::vector<double>
  along(const SpanModel& model) const;

private:
  /** A free point near a wire: its place along the line and its meter below the wire, 0
   * for what is level with it, as a crossarm is. */
  struct Slice {
    double s;
    int meter;
  };

  /** A wire of a line as seen along the line. */
  struct Seen {
    Profile profile; ///< heights over the wire's own model
    double begin, end;
    std::vector<Slice> vertical_slice; ///< free points around and below, by place
  };

  struct Stretch;

  void
  add(const Piece& wire, const Growth& growth);

  std::vector<Stretch>
  stretches(double low, double high) const;

  static double
  kinkAt(double s, const std::vector<Stretch>& wires);

  double
  poleAt(double s) const;

  void
  search(double low, double high);

  SpanModel axis_;
  std::vector<Seen> wires_;
  std::vector<double> columns_; ///< that stand below a wire
  std::vector<double> found_;
};

} // namespace linelet::powerline
