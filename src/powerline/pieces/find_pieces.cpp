// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/find_pieces.h"

#include <utility>

#include "powerline/pieces/candidates.h"
#include "powerline/pieces/evidence.h"
#include "powerline/pieces/growth.h"
#include "powerline/pieces/wide_beam.h"

namespace linelet::powerline {

namespace {

constexpr double bundle_tolerance = 0.15; // meters; what fits closer is one wire
// Points per meter of a bundle, else its guard ring says nothing.
constexpr double bundle_density = 6;

} // namespace

// A bundle whose conductors the points do not tell apart fills a wider tube, and the
// guard ring lies around that.
bool
becomesBundle(const Growth& growth, Piece& piece, const PowerLineSettings& settings)
{
  if (piece.model.length() < settings.min_length ||
      piece.model.tolerance < bundle_tolerance ||
      static_cast<double>(piece.members.size()) < bundle_density * piece.model.length())
    return false;
  Piece bundle = piece;
  bundle.thickness = bundle_radius;
  // Twice: the first time from the conductor that was followed to the middle.
  if (!growth.collect(bundle, bundle_radius) ||
      !growth.collect(bundle, bundle_radius) ||
      !weigh(growth, bundle, settings).accepted)
    return false;
  piece = std::move(bundle);
  return true;
}

std::vector<Piece>
growAll(Growth& growth,
        const std::vector<Seed>& seeds,
        const PowerLineSettings& settings,
        ProgressMonitor* monitor)
{
  std::vector<Piece> wires;
  std::vector<char> tried(growth.candidates().points.size(), 0);
  if (monitor != nullptr)
    monitor->begin("wires", seeds.size());
  for (std::size_t k = 0; k < seeds.size(); ++k) {
    if (monitor != nullptr && k % 256 == 255) {
      monitor->advance(256);
      if (monitor->canceled())
        throw Canceled();
    }
    if (tried[seeds[k].candidate] != 0)
      continue;
    tried[seeds[k].candidate] = 1;
    for (Piece& piece : growth.grow(seeds[k])) {
      // What looks like a bundle is not a single wire in a wide beam.
      bool found = !weigh(growth, piece, settings).accepted &&
                   becomesBundle(growth, piece, settings);
      if (!found) {
        widenToBeam(growth, piece, settings);
        found = weigh(growth, piece, settings).accepted;
      }
      if (found) {
        growth.claim(piece, static_cast<int>(wires.size()));
        wires.push_back(std::move(piece));
      }
      else
        for (const Index i : piece.members)
          tried[i] = 1;
    }
  }
  return wires;
}

} // namespace linelet::powerline
