// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// The neighborhood tensor of one query per work-item.
//
// Built with constants: CENTROID (CENTROID_Mean and the like), TENSOR_WEIGHT and
// CENTROID_WEIGHT (KERNEL_Linear and the like) with their parameters W_FIRST, W_SECOND,
// C_FIRST and C_SECOND; BY_COUNT if sums are divided by the number of neighbors instead
// of their weight; EXACT where the device computes in double; and ENDING_AT_POINTS if all
// balls reach to the k-th nearest point, which float never decides. Left out of programs
// built without them.

#if defined(CENTROID) && !defined(NEAREST)

#define MOST_MEDIAN_STEPS 300
#define MEDIAN_STEP 1e-7f // a shorter step, in units of the radius, ends the iteration
#define UNDECIDED 0xffffffffu // instead of a count: the host is to decide

// The centroid that this program was built for; see linelet::centroid.
INLINE void
findCentroid(const Walk* walk, const bool exact, float* cx, float* cy, float* cz)
{
  *cx = *cy = *cz = 0;
#if CENTROID != CENTROID_QueryPoint
  Sums s = walkNeighbors(walk, 0, 0, 0, SWEEP_CENTROID, exact);
  if (s.weight > 0) {
    *cx = s.x / s.weight;
    *cy = s.y / s.weight;
    *cz = s.z / s.weight;
  }
#endif
#if CENTROID == CENTROID_Median
  for (int step = 0; step < MOST_MEDIAN_STEPS; ++step) {
    s = walkNeighbors(walk, *cx, *cy, *cz, SWEEP_PULL, exact);
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
  Sums sums = walkNeighbors(walk, cx, cy, cz, SWEEP_MOMENTS, exact);
#if TENSOR_WEIGHT == 0
  sums.weight = (float)sums.count;
#endif
  return sums;
}

// The tensor of the query at every place, component by component (`stride` apart): xx
// xy xz yy yz zz; NaN where no neighbor has weight. And the number of neighbors;
// UNDECIDED where only double could tell and the device has none.
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
  const float radius = radii[i];
  Walk walk =
      walkAround(i, query_slot[place], table, offsets, cells, cell_size, x, y, z);
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
#ifdef ENDING_AT_POINTS
  Sums s = tensorSums(&walk, true);
#else
  Sums s = tensorSums(&walk, false);
  if (s.border > 0) {
#ifdef EXACT
    s = tensorSums(&walk, true);
#else
    s.count = UNDECIDED;
#endif
  }
#endif
#ifdef BY_COUNT
  s.weight = s.count;
#endif
  global float* t = components + place;
  t[0] = s.xx / s.weight;
  t[stride] = s.xy / s.weight;
  t[2 * stride] = s.xz / s.weight;
  t[3 * stride] = s.yy / s.weight;
  t[4 * stride] = s.yz / s.weight;
  t[5 * stride] = s.zz / s.weight;
  counts[place] = s.count;
}

#endif // CENTROID and not NEAREST
