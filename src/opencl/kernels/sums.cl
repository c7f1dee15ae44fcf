// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Sums over the neighbors of one query, WIDTH of them at a time.

#ifdef CENTROID

#define MEDIAN_HERE 1e-6f // neighbors this close to the iterate count as coincident

typedef struct {
  float weight, x, y, z;
  float xx, xy, xz, yy, yz, zz;
  uint count;
  uint border; // undecided pairs
} Sums;

// The same per lane; added up once, after the last run.
typedef struct {
  Floats weight, x, y, z;
  Floats xx, xy, xz, yy, yz, zz;
  Ints count;  // neighbors
  Ints border; // pairs not decided yet
} LaneSums;

#define SWEEP_MOMENTS 0  // weighted tensor about the center
#define SWEEP_CENTROID 1 // weighted sum of positions; weights by distance to the query
#define SWEEP_PULL 2     // Weiszfeld's iteration at the center
#define SWEEP_COUNT 3    // nothing but the counts
#define SWEEP_RANK 4     // the same, and undecided points go to the ranking

// Decides the lanes next to the border of the ball; `share`, their distance in units of
// the radius, stays on the side of 1 where it is in double, as a weight may end there
// in a step.
INLINE Ints
decideBorder(const Walk* walk, uint first, Floats squared, Ints inside, Floats* share)
{
#ifdef EXACT
  const Ints border =
      MASK_IF(squared > walk->surely_inside && squared <= walk->perhaps_inside);
  if (!ANY(border))
    return inside;
  int lanes[WIDTH], decided[WIDTH];
  float shares[WIDTH];
  STORE(border, lanes);
  STORE(inside, decided);
  STORE(*share, shares);
  for (uint lane = 0; lane < WIDTH; ++lane) {
    if (lanes[lane] == 0)
      continue;
    const double sum = exactSquared(walk, first + lane);
    decided[lane] = sum <= walk->radius * walk->radius ? -1 : 0;
    const double exact_share = sqrt(sum) * (1 / walk->radius);
    shares[lane] = exact_share < 1 ? min((float)exact_share, 0x1.fffffep-1f)
                                   : max((float)exact_share, 1.0f);
  }
  *share = LOAD(shares);
  return LOAD(decided);
#else
  return inside;
#endif
}

#ifdef NEAREST
// Ranks the points of the lanes for which `undecided` holds.
INLINE void
rankLanes(const Walk* walk, uint first, Ints undecided)
{
  if (!ANY(undecided))
    return;
  int lanes[WIDTH];
  STORE(undecided, lanes);
  Ranking* ranking = walk->ranking;
  for (uint lane = 0; lane < WIDTH; ++lane) {
    if (lanes[lane] == 0)
      continue;
    if (ranking->count < MOST_RANKED) {
      const double squared = exactSquared(walk, first + lane);
      uint at = ranking->count;
      for (; at > 0 && ranking->squared[at - 1] > squared; --at)
        ranking->squared[at] = ranking->squared[at - 1];
      ranking->squared[at] = squared;
    }
    ++ranking->count;
  }
}
#endif

// Adds the neighbors among WIDTH sorted points, of which only the first `left` count at
// the tail of a run; o is the query in the coordinates of the run, c the center
// relative to the query.
INLINE void
addPoints(const Walk* walk,
          uint first,
          int left,
          float ox,
          float oy,
          float oz,
          float cx,
          float cy,
          float cz,
          const bool tail,
          const int sweep,
          const bool exact,
          LaneSums* sums)
{
  const Floats zero = 0;
  const Floats dx = LOAD(walk->x + first) - ox, dy = LOAD(walk->y + first) - oy,
               dz = LOAD(walk->z + first) - oz;
  const Floats squared = dx * dx + dy * dy + dz * dz;
  Ints inside = MASK_IF(squared <= walk->surely_inside);
  Ints border = MASK_IF(squared <= walk->perhaps_inside);
  const float scale = walk->inverse_radius;
  Floats share = sqrt(squared) * scale; // distance to the query in units of the radius
  if (exact)
    inside = decideBorder(walk, first, squared, inside, &share);
  if (tail) {
    const Ints valid = MASK_IF(LANES < left);
    inside &= valid;
    border &= valid;
  }
  // Written as choices, which are masked additions where the device has them.
  sums->count = inside ? sums->count + 1 : sums->count;
  if (!exact)
    sums->border = border ? sums->border + 1 : sums->border;
#ifdef NEAREST
  if (sweep == SWEEP_RANK)
    rankLanes(walk, first, border & ~inside);
#endif
  if (sweep == SWEEP_COUNT || sweep == SWEEP_RANK)
    return;
  const Floats vx = dx - cx, vy = dy - cy, vz = dz - cz;
  if (sweep == SWEEP_CENTROID) {
    const Floats wanted =
        CENTROID != CENTROID_WeightedMean ? 1 : weightOf(CENTROID_WEIGHT, C_FIRST, C_SECOND, share);
    const Floats w = inside ? wanted : zero;
    sums->x += w * dx;
    sums->y += w * dy;
    sums->z += w * dz;
    sums->weight += w;
  }
  else if (sweep == SWEEP_PULL) {
    const Floats distance = sqrt(vx * vx + vy * vy + vz * vz);
    const Floats one = 1;
    const Floats w = inside ? one : zero;
    // Neighbors at the center do not pull; their number is kept in xx.
    const Ints here = MASK_IF(distance * scale < MEDIAN_HERE);
    const Floats stiffness = here ? zero : w / distance;
    sums->x += stiffness * vx;
    sums->y += stiffness * vy;
    sums->z += stiffness * vz;
    sums->weight += stiffness;
    sums->xx += here ? w : zero;
  }
  else {
#if TENSOR_WEIGHT == 0 // const: the weight of all is their number
    sums->xx = inside ? sums->xx + vx * vx : sums->xx;
    sums->xy = inside ? sums->xy + vx * vy : sums->xy;
    sums->xz = inside ? sums->xz + vx * vz : sums->xz;
    sums->yy = inside ? sums->yy + vy * vy : sums->yy;
    sums->yz = inside ? sums->yz + vy * vz : sums->yz;
    sums->zz = inside ? sums->zz + vz * vz : sums->zz;
#else
#if CENTROID != CENTROID_QueryPoint
    share = sqrt(vx * vx + vy * vy + vz * vz) * scale; // to the centroid
#endif
    const Floats wanted = weightOf(TENSOR_WEIGHT, W_FIRST, W_SECOND, share);
    const Floats w = inside ? wanted : zero;
    const Floats wx = w * vx, wy = w * vy, wz = w * vz;
    sums->weight += w;
    sums->xx += wx * vx;
    sums->xy += wx * vy;
    sums->xz += wx * vz;
    sums->yy += wy * vy;
    sums->yz += wy * vz;
    sums->zz += wz * vz;
#endif
  }
}

// Adds a run of sorted points. Reads up to WIDTH - 1 points beyond its end.
INLINE void
walkRun(const Walk* walk,
        uint begin,
        uint end,
        float ox,
        float oy,
        float oz,
        float cx,
        float cy,
        float cz,
        const int sweep,
        const bool exact,
        LaneSums* sums)
{
  uint i = begin;
  for (; i + WIDTH <= end; i += WIDTH)
    addPoints(walk, i, WIDTH, ox, oy, oz, cx, cy, cz, false, sweep, exact, sums);
  if (i < end)
    addPoints(walk, i, (int)(end - i), ox, oy, oz, cx, cy, cz, true, sweep, exact, sums);
}

// Sums over all neighbors; the center is relative to the query.
INLINE Sums
walkNeighbors(
    const Walk* walk, float cx, float cy, float cz, const int sweep, const bool exact)
{
  LaneSums lanes = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  for (int number = 0; number < ROWS; ++number) {
    const Row row = rowOf(walk, number);
    walkRun(walk, row.begin, row.middle, walk->qx, row.qy, row.qz, cx, cy, cz,
            sweep, exact, &lanes);
    walkRun(walk, row.middle, row.end, walk->next_qx, row.qy, row.qz, cx, cy, cz,
            sweep, exact, &lanes);
  }
  Sums sums;
  sums.weight = sumFloats(lanes.weight);
  sums.x = sumFloats(lanes.x);
  sums.y = sumFloats(lanes.y);
  sums.z = sumFloats(lanes.z);
  sums.xx = sumFloats(lanes.xx);
  sums.xy = sumFloats(lanes.xy);
  sums.xz = sumFloats(lanes.xz);
  sums.yy = sumFloats(lanes.yy);
  sums.yz = sumFloats(lanes.yz);
  sums.zz = sumFloats(lanes.zz);
  sums.count = sumInts(lanes.count);
  sums.border = exact ? 0 : sumInts(lanes.border) - sums.count;
  return sums;
}

#endif // CENTROID
