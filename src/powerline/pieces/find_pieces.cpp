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

constexpr double bundle_tolerance = 0.15; // meters; a closer fit is a single wire
// Points per meter of a bundle, without which its guard ring is meaningless: while its
// wires might still be resolved, and after single wires have been found.
constexpr double bundle_density = 6, last_density = 3;

// Whether a piece is a bundle with unresolved conductors: it then fills a wider tube,
// with the guard ring around that.
bool
isBundle(const Growth& growth,
         Piece& piece,
         double least_density,
         const PowerLineSettings& settings)
{
  if (piece.model.length() < settings.min_length ||
      piece.model.tolerance < bundle_tolerance ||
      static_cast<double>(piece.members.size()) < least_density * piece.model.length())
    return false;
  Piece bundle = piece;
  bundle.thickness = bundle_radius;
  // Twice: the first time moves from the conductor that was followed to the middle.
  if (!growth.collect(bundle, bundle_radius) ||
      !growth.collect(bundle, bundle_radius) ||
      !weigh(growth, bundle, settings).accepted)
    return false;
  piece = std::move(bundle);
  return true;
}

} // namespace

bool
becomesBundle(const Growth& growth, Piece& piece, const PowerLineSettings& settings)
{
  return isBundle(growth, piece, bundle_density, settings);
}

std::vector<Piece>
growAll(Growth& growth,
        const std::vector<Seed>& seeds,
        const PowerLineSettings& settings,
        ProgressMonitor* monitor)
{
  std::vector<Piece> wires;
  // Wires that failed because of nearby unclaimed ones get a second chance.
  for (int round = 0; round < 2; ++round) {
    std::vector<char> tried(growth.candidates().points.size(), 0);
    const std::size_t before = wires.size();
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
        // A piece that looks like a bundle is not a single wire in a wide beam.
        bool found = !weigh(growth, piece, settings).accepted &&
                     isBundle(growth, piece, bundle_density, settings);
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
    if (wires.size() == before)
      break;
  }
  return wires;
}

void
addBundles(Growth& growth,
           const std::vector<Seed>& seeds,
           std::vector<Piece>& pieces,
           const PowerLineSettings& settings)
{
  std::vector<char> tried(growth.candidates().points.size(), 0);
  for (const Seed& seed : seeds) {
    if (tried[seed.candidate] != 0)
      continue;
    tried[seed.candidate] = 1;
    for (Piece& piece : growth.grow(seed)) {
      for (const Index i : piece.members)
        tried[i] = 1;
      if (!isBundle(growth, piece, last_density, settings))
        continue;
      growth.claim(piece, static_cast<int>(pieces.size()));
      pieces.push_back(std::move(piece));
    }
  }
}

} // namespace linelet::powerline
