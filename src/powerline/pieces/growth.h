// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include <linelet/powerline/power_line_settings.h>

#include "powerline/pieces/candidates.h"
#include "powerline/pieces/piece.h"
#include "powerline/pieces/span_model.h"
#include "powerline/pieces/tangents.h"

namespace linelet::powerline {

/** \brief What stands around one bin of a wire. */
struct Bin {
  std::size_t tube = 0;       ///< points within the tolerance
  std::size_t guard_ring = 0; ///< points beyond it, up to twice the tolerance
  std::size_t ring = 0;       ///< points from the tolerance to \ref ring_radius
};

constexpr double bin_length = 2;      ///< meters
constexpr double bundle_radius = 0.5; ///< meters, of a bundle drawn as one wire
constexpr double growth_gap = 8;      ///< meters without a point that are not unusual
constexpr double ring_radius =
    0.8; ///< meters, of the surroundings that a bin is compared with

/// Evidence (nats) against a wire ahead at which the search for it stops: some 15 m in
/// a scan with one point per meter.
constexpr double usual_patience = 8;

/** \brief Grows wires from seeds and keeps track of which wire owns which candidate. */
class Growth {
public:
  static constexpr int nobody = -1;

  /** \param[in] seeds that give the directions of wires */
  Growth(const Candidates& candidates,
         const PowerLineSettings& settings,
         const std::vector<Seed>& seeds = {});

  /** \brief The parts between supports of a wire grown from \a seed in both directions.
   * Claims nothing. Empty if nothing grows. */
  std::vector<Piece>
  grow(const Seed& seed) const;

  /** \brief The parts of \a piece between supports that it passes, each collected,
   * fitted and extended by itself. */
  std::vector<Piece>
  betweenSupports(Piece piece) const;

  /** \brief Extends \a piece at both ends, not beyond \a low and \a high, as long as
   * points farther ahead make up for gaps before them: a wire shows with the density of
   * the piece, or is hidden. Stops when the evidence against a wire reaches \a patience
   * nats, or when its position can no longer be predicted.
   * \param[in] lock shift it to the strongest of the wires around once it is long
   * enough to resolve them
   * \return false if nothing of it is left */
  bool
  extend(Piece& piece,
         double low = -std::numeric_limits<double>::infinity(),
         double high = std::numeric_limits<double>::infinity(),
         bool lock = false,
         double patience = usual_patience) const;

  /** \brief Takes the free points within \a reach of the model as members, from begin
   * to end, and fits again. False if too few are left. */
  bool
  collect(Piece& piece, double reach) const;

  /** \brief Counts around the stretch [\a from, \a to] of \a model; the free points of
   * the tube are added to \a members if that is not null. Points of \a self count as
   * free. */
  Bin
  look(const SpanModel& model,
       double from,
       double to,
       double tolerance,
       Indices* members = nullptr) const;

  /** \brief Makes \a owner the owner of all members of \a piece. */
  void
  claim(const Piece& piece, int owner);

  /** \brief Makes all candidates free again. */
  void
  release();

  int
  owner(Index candidate) const
  {
    return owner_[candidate];
  }

  const Candidates&
  candidates() const
  {
    return candidates_;
  }

private:
  /** What lies ahead of an end, not yet part of the piece. */
  struct Ahead {
    bool open = true;    ///< whether to continue
    double gap = 0;      ///< meters examined
    double evidence = 0; ///< for a wire in them, never positive
    Indices points;      ///< in the tube there
  };

  void
  advance(Piece& piece, int side, double limit, double patience, Ahead& ahead) const;

  bool
  lockOnStrongestWire(Piece& piece) const;

  /** The parts of \a piece between the downward breaks of slope of all wires around
   * it. */
  std::vector<Piece>
  betweenBreaks(const Piece& piece) const;

  const Candidates& candidates_;
  const PowerLineSettings& settings_;
  std::vector<int> owner_;
  Tangents tangents_;
};

} // namespace linelet::powerline
