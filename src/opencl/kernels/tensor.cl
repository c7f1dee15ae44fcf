// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// The neighbourhood tensor of one query per work-item.
//
// Built with constants: CENTROID (the enumerator of linelet::Centroid), TENSOR_WEIGHT and
// CENTROID_WEIGHT with their parameters W_FIRST, W_SECOND, C_FIRST, C_SECOND, and EXACT
// where the device computes in double; left out of programs built without them.
//
// All lengths are in float relative to the query point, which no offset of the cloud
// touches. Where a squared distance lies within BAND of the squared radius, the query is
// walked once more and such pairs are decided by the rule of all engines, d^2 <= r^2 in
// double.

#ifdef CENTROID

#define BAND 1.5e-5f
#define BIN_ROUNDING 1e-3f // of a bin
#define MOST_MEDIAN_STEPS 300
#define MEDIAN_STEP 1e-7f // a shorter step, in units of the radius, ends the iteration
#define MEDIAN_HERE 1e-6f // neighbours so close to the iterate count as lying at it

typedef struct {
  global const float *x, *y, *z; // sorted points, relative to chunk and cells
  global const uint* table;      // ROWS x ROW_PLACES of the query's cell
  float qx, next_qx;             // query, relative to the first and next chunk of the rows
  float bx;                      // the same, relative to the first bin of the rows
  float qy, qz;                  // query, relative to its cell
  int next_chunk;                // bin with which the next chunk begins
  float cell_size, inverse_radius;
  float surely_inside, perhaps_inside; // squared distances, see BAND
#ifdef EXACT
  global const ulong* points;   // sorted keys
  ulong index_mask;             // the part of them that is the index
  global const double* exact;   // points by index
  global const double* query;   // this query
  double radius;
#endif
} Walk;

typedef struct {
  float weight, x, y, z;
  float xx, xy, xz, yy, yz, zz;
  uint count;
  uint border; // pairs too close to the radius to be decided in float
} Sums;

// The same lane by lane; added up once, after the last run.
typedef struct {
  Floats weight, x, y, z;
  Floats xx, xy, xz, yy, yz, zz;
  Ints count;  // neighbours
  Ints border; // pairs not decided yet
} LaneSums;

#define SWEEP_MOMENTS 0  // weighted tensor about the centre
#define SWEEP_CENTROID 1 // weighted sum of positions; weights by distance to the query
#define SWEEP_PULL 2     // Weiszfeld's iteration at the centre

// Decides the lanes that lie next to the border of the ball; `share`, their distance in
// units of the radius, stays on the side of 1 on which it is in double, as a weight may
// end there in a step.
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
#if WIDTH == 1
  lanes[0] = border;
  decided[0] = inside;
  shares[0] = *share;
#else
  JOIN(vstore, WIDTH)(border, 0, lanes);
  JOIN(vstore, WIDTH)(inside, 0, decided);
  JOIN(vstore, WIDTH)(*share, 0, shares);
#endif
  for (uint lane = 0; lane < WIDTH; ++lane) {
    if (lanes[lane] == 0)
      continue;
    global const double* point =
        walk->exact + 3 * (walk->points[first + lane] & walk->index_mask);
    const double dx = point[0] - walk->query[0], dy = point[1] - walk->query[1],
                 dz = point[2] - walk->query[2];
    // Rounded after every operation and added in the order of the other engines: volatile
    // keeps compilers from fusing and reordering.
    volatile double xx = dx * dx, yy = dy * dy, zz = dz * dz;
    volatile double xx_yy = xx + yy;
    volatile double sum = xx_yy + zz;
    decided[lane] = sum <= walk->radius * walk->radius ? -1 : 0;
    const double exact_share = sqrt(sum) * (1 / walk->radius);
    shares[lane] = exact_share < 1 ? min((float)exact_share, 0x1.fffffep-1f)
                                   : max((float)exact_share, 1.0f);
  }
#if WIDTH == 1
  *share = shares[0];
  return decided[0];
#else
  *share = JOIN(vload, WIDTH)(0, shares);
  return JOIN(vload, WIDTH)(0, decided);
#endif
#else
  return MASK_IF(squared * walk->inverse_radius * walk->inverse_radius <= 1);
#endif
}

// Adds the neighbours among WIDTH sorted points, of which only the first `left` count if
// this is the tail of a run; o is the query as the run's coordinates see it, c the centre
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
  const Floats vx = dx - cx, vy = dy - cy, vz = dz - cz;
  if (sweep == SWEEP_CENTROID) {
    const Floats wanted =
        CENTROID != 2 ? 1 : weightOf(CENTROID_WEIGHT, C_FIRST, C_SECOND, share);
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
    // Neighbours at the centre pull nowhere; their number is kept in xx.
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
#if CENTROID != 0
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

// Distance between a place and the interval [0, width].
INLINE float
distanceTo(float place, float width)
{
  return max(max(place - width, -place), 0.0f);
}

// Sums over all neighbours; the centre is relative to the query.
INLINE Sums
walkNeighbours(
    const Walk* walk, float cx, float cy, float cz, const int sweep, const bool exact)
{
  LaneSums lanes = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  const float bins_a_length = BINS / walk->cell_size;
  for (int row = 0; row < ROWS; ++row) {
    // The query as the row's cells see it.
    const float oy = walk->qy - (float)(row % SIDE - REACH) * walk->cell_size;
    const float oz = walk->qz - (float)(row / SIDE - REACH) * walk->cell_size;
    const float dy = distanceTo(oy, walk->cell_size);
    const float dz = distanceTo(oz, walk->cell_size);
    const float left_over = walk->perhaps_inside - dy * dy - dz * dz;
    if (left_over < 0)
      continue;
    // The bins that the ball meets; a little more, for the rounding of bins and roots.
    const float chord = sqrt(left_over);
    const float first = (walk->bx - chord) * bins_a_length - BIN_ROUNDING;
    const float last = (walk->bx + chord) * bins_a_length + BIN_ROUNDING + 1;
    global const uint* places = walk->table + ROW_PLACES * row;
    const uint begin = places[(int)clamp(first, 0.0f, (float)ROW_BINS)];
    const uint end = places[(int)clamp(last, 0.0f, (float)ROW_BINS)];
    const uint chunk_end = clamp(places[walk->next_chunk], begin, end);
    walkRun(walk, begin, chunk_end, walk->qx, oy, oz, cx, cy, cz, sweep, exact, &lanes);
    walkRun(walk,
            chunk_end,
            end,
            walk->next_qx,
            oy,
            oz,
            cx,
            cy,
            cz,
            sweep,
            exact,
            &lanes);
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

// The centroid by which this program was built; see linelet::centroid.
INLINE void
findCentroid(const Walk* walk, const bool exact, float* cx, float* cy, float* cz)
{
  *cx = *cy = *cz = 0;
#if CENTROID != 0
  Sums s = walkNeighbours(walk, 0, 0, 0, SWEEP_CENTROID, exact);
  if (s.weight > 0) {
    *cx = s.x / s.weight;
    *cy = s.y / s.weight;
    *cz = s.z / s.weight;
  }
#endif
#if CENTROID == 3
  for (int step = 0; step < MOST_MEDIAN_STEPS; ++step) {
    s = walkNeighbours(walk, *cx, *cy, *cz, SWEEP_PULL, exact);
    const float resultant = sqrt(s.x * s.x + s.y * s.y + s.z * s.z);
    if (!(s.weight > 0) || resultant <= s.xx)
      return;
    const float length = (1 - s.xx / resultant) / s.weight;
    *cx += length * s.x;
    *cy += length * s.y;
    *cz += length * s.z;
    if (length * resultant * walk->inverse_radius <= MEDIAN_STEP)
      return;
  }
#endif
}

INLINE Sums
tensorSums(const Walk* walk, const bool exact)
{
  float cx, cy, cz;
  findCentroid(walk, exact, &cx, &cy, &cz);
  Sums sums = walkNeighbours(walk, cx, cy, cz, SWEEP_MOMENTS, exact);
#if TENSOR_WEIGHT == 0
  sums.weight = (float)sums.count;
#endif
  return sums;
}

// The tensor of the query at every place, component after component (`stride` apart): xx xy
// xz yy yz zz; NaN where no neighbour has weight. And how many neighbours there are.
kernel void
tensors(global const ulong* queries,
        uint count,
        KeyLayout layout,
        global const uint* query_slot,
        global const uint* table,
        global const float* offsets,
        global const int4* cells,
        global const float* radii,
        float cell_size,
        global const float* x,
        global const float* y,
        global const float* z,
        uint stride,
        global float* components,
        global uint* counts
#ifdef EXACT
        ,
        global const ulong* points,
        global const double* point_positions,
        global const double* query_positions,
        global const double* exact_radii
#endif
)
{
  const uint place = get_global_id(0);
  if (place >= count)
    return;
  const ulong index_mask = ((ulong)1 << layout.index_bits) - 1;
  const uint i = (uint)(queries[place] & index_mask);
  const int first_cell = cells[i].x - REACH; // of the rows
  const float radius = radii[i];
  Walk walk;
  walk.x = x;
  walk.y = y;
  walk.z = z;
  walk.table = table + TABLE_SIZE * query_slot[place];
  const float in_own_chunk = placeInChunk(offsets[3 * i], cells[i].x, cell_size);
  const float chunk_step = cell_size * (float)(CHUNK_MASK + 1);
  const bool begins_in_own = (first_cell & ~CHUNK_MASK) == (cells[i].x & ~CHUNK_MASK);
  walk.qx = begins_in_own ? in_own_chunk : in_own_chunk + chunk_step;
  walk.next_qx = begins_in_own ? in_own_chunk - chunk_step : in_own_chunk;
  walk.bx = offsets[3 * i] + cell_size * (float)REACH;
  walk.qy = offsets[3 * i + 1];
  walk.qz = offsets[3 * i + 2];
  walk.next_chunk = min((CHUNK_MASK + 1 - (first_cell & CHUNK_MASK)) * BINS, ROW_BINS);
  walk.cell_size = cell_size;
  walk.inverse_radius = 1 / radius;
  walk.surely_inside = radius * radius * (1 - BAND);
  walk.perhaps_inside = radius * radius * (1 + BAND);
#ifdef EXACT
  walk.points = points;
  walk.index_mask = index_mask;
  walk.exact = point_positions;
  walk.query = query_positions + 3 * i;
  walk.radius = exact_radii[i];
#endif
  Sums s = tensorSums(&walk, false);
  if (s.border > 0)
    s = tensorSums(&walk, true);
  global float* t = components + place;
  t[0] = s.xx / s.weight;
  t[stride] = s.xy / s.weight;
  t[2 * stride] = s.xz / s.weight;
  t[3 * stride] = s.yy / s.weight;
  t[4 * stride] = s.yz / s.weight;
  t[5 * stride] = s.zz / s.weight;
  counts[place] = s.count;
}

#endif // CENTROID
