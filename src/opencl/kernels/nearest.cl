// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// The distance of the k-th nearest point, one query per work-item.
//
// Counting narrows an interval of squared distances until few points remain in it, and
// these are ranked in double. Nothing is stored for the others, whatever k is.

#ifdef NEAREST

#define MOST_COUNTS 40
#define FEW (MOST_RANKED / 2) // points around which double decides may come on top

INLINE uint
countWithin(Walk* walk, float squared)
{
  walk->surely_inside = walk->perhaps_inside = squared;
  return walkNeighbors(walk, 0, 0, 0, SWEEP_COUNT, false).count;
}

// The squared distance, by index of the query. NaN where fewer than k points lie within
// `reach`, the width of a cell, and where too many lie about as far as the k-th.
kernel void
nearestSquares(global const ulong* queries,
               uint count,
               KeyLayout layout,
               global const uint* query_slot,
               global const uint* table,
               global const float* offsets,
               global const int4* cells,
               float cell_size,
               global const float* x,
               global const float* y,
               global const float* z,
               global const ulong* points,
               global const double* point_positions,
               global const double* query_positions,
               global const uint* wanted,
               float reach,
               global double* squares)
{
  const uint place = get_global_id(0);
  if (place >= count)
    return;
  const ulong index_mask = ((ulong)1 << layout.index_bits) - 1;
  const uint i = (uint)(queries[place] & index_mask);
  Ranking ranking;
  ranking.count = 0;
  Walk walk =
      walkAround(i, query_slot[place], table, offsets, cells, cell_size, x, y, z);
  walk.inverse_radius = 1 / reach;
  walk.points = points;
  walk.index_mask = index_mask;
  walk.exact = point_positions;
  walk.query = query_positions + 3 * i;
  walk.ranking = &ranking;

  squares[i] = NAN;
  const uint k = wanted[i];
  float low = 0, high = reach * reach; // the k-th lies above low, up to high
  uint below = 0, within = countWithin(&walk, high);
  if (within < k)
    return;
  float aim = k; // a few beyond the k-th, to close in on it from the other side
  for (uint step = 0; step < MOST_COUNTS && within - below > FEW; ++step) {
    // Linear interpolation; sometimes the midpoint, for densities that jump.
    const float line = clamp((aim - below) / (within - below), 0.01f, 0.99f);
    const float middle = low + (high - low) * (step % 4 == 3 ? 0.5f : line);
    const uint counted = countWithin(&walk, middle);
    if (counted < k) {
      low = middle;
      below = counted;
      aim = k + 0.25f * FEW;
    }
    else {
      high = middle;
      within = counted;
      aim = k - 0.25f * FEW;
    }
  }
  const float margin = BAND * reach * sqrt(high);
  walk.surely_inside = low - margin;
  walk.perhaps_inside = high + margin;
  const uint inside = walkNeighbors(&walk, 0, 0, 0, SWEEP_RANK, false).count;
  if (ranking.count <= MOST_RANKED && inside < k && k - inside <= ranking.count)
    squares[i] = ranking.squared[k - inside - 1];
}

#endif // NEAREST
