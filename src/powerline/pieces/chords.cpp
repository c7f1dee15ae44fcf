// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/pieces/chords.h"

#include <algorithm>

#include "powerline/line_priors.h"
#include "powerline/pieces/bend.h"
#include "powerline/pieces/parallel.h"
#include "powerline/pieces/span_model.h"

namespace linelet::powerline {

namespace {

constexpr double least_overlap = 10; // meters of a wire beside it

} // namespace

void
dropChords(Growth& growth, std::vector<Piece>& pieces)
{
  const Points& points = growth.candidates().points;
  std::vector<Bend> bends;
  for (const Piece& piece : pieces)
    bends.push_back(bendOf(piece, points));
  std::vector<char> chord(pieces.size(), 0);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (pieces[k].model.length() < straight_length || !bends[k].rulesOut(flattest))
      continue;
    for (std::size_t w = 0; w < pieces.size() && chord[k] == 0; ++w) {
      if (!bends[w].isAbove(flattest))
        continue;
      const Parallel parallel = compare(pieces[w].model, pieces[k].model);
      chord[k] = parallel.overlap >= least_overlap && parallel.distance <= priors.rack;
    }
  }
  std::vector<Piece> kept;
  for (std::size_t k = 0; k < pieces.size(); ++k)
    if (chord[k] != 0)
      growth.claim(pieces[k], Growth::nobody);
    else
      kept.push_back(std::move(pieces[k]));
  pieces = std::move(kept);
}

} // namespace linelet::powerline
