// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Walks over the sorted points around one query.
//
// Part of programs built with CENTROID defined, see tensor.cl; EXACT stands for devices that
// compute in double.
//
// All lengths are in float relative to the query point, which no offset of the cloud
// touches. Where a squared distance lies within BAND of the squared radius, float does not
// decide: such pairs are undecided until the rule of all engines, d^2 <= r^2 in double.

#ifdef CENTROID

#define BAND 1.5e-5f       // of the squared radius, for radii of half a cell and more
#define BIN_ROUNDING 1e-3f // of a bin

#ifdef NEAREST
#define MOST_RANKED 32
// Squared distances of the first undecided points, ascending.
typedef struct {
  double squared[MOST_RANKED];
  uint count; // of all of them
} Ranking;
#endif

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
#ifdef NEAREST
  Ranking* ranking;
#endif
} Walk;

// The walk around query i in the cell of the given slot; its radius is not set yet.
INLINE Walk
walkAround(uint i,
           uint slot,
           global const uint* table,
           global const float* offsets,
           global const int4* cells,
           float cell_size,
           global const float* x,
           global const float* y,
           global const float* z)
{
  const int first_cell = cells[i].x - REACH; // of the rows
  const float in_own_chunk = placeInChunk(offsets[3 * i], cells[i].x, cell_size);
  const float chunk_step = cell_size * (float)(CHUNK_MASK + 1);
  const bool begins_in_own = (first_cell & ~CHUNK_MASK) == (cells[i].x & ~CHUNK_MASK);
  Walk walk;
  walk.x = x;
  walk.y = y;
  walk.z = z;
  walk.table = table + TABLE_SIZE * slot;
  walk.qx = begins_in_own ? in_own_chunk : in_own_chunk + chunk_step;
  walk.next_qx = begins_in_own ? in_own_chunk - chunk_step : in_own_chunk;
  walk.bx = offsets[3 * i] + cell_size * (float)REACH;
  walk.qy = offsets[3 * i + 1];
  walk.qz = offsets[3 * i + 2];
  walk.next_chunk = min((CHUNK_MASK + 1 - (first_cell & CHUNK_MASK)) * BINS, ROW_BINS);
  walk.cell_size = cell_size;
  return walk;
}

// A row of cells as the query sees it, and the points in it that may be neighbors: one run
// up to `middle`, relative to the first chunk, and one behind it, relative to the next.
typedef struct {
  float qy, qz;
  uint begin, middle, end;
} Row;

// Distance between a place and the interval [0, width].
INLINE float
distanceTo(float place, float width)
{
  return max(max(place - width, -place), 0.0f);
}

INLINE Row
rowOf(const Walk* walk, int number)
{
  Row row = {walk->qy - (float)(number % SIDE - REACH) * walk->cell_size,
             walk->qz - (float)(number / SIDE - REACH) * walk->cell_size,
             0,
             0,
             0};
  const float dy = distanceTo(row.qy, walk->cell_size);
  const float dz = distanceTo(row.qz, walk->cell_size);
  const float left_over = walk->perhaps_inside - dy * dy - dz * dz;
  if (left_over < 0)
    return row;
  // The bins that the ball meets; a little more, for the rounding of bins and roots.
  const float bins_a_length = BINS / walk->cell_size;
  const float chord = sqrt(left_over);
  const float first = (walk->bx - chord) * bins_a_length - BIN_ROUNDING;
  const float last = (walk->bx + chord) * bins_a_length + BIN_ROUNDING + 1;
  global const uint* places = walk->table + ROW_PLACES * number;
  row.begin = places[(int)clamp(first, 0.0f, (float)ROW_BINS)];
  row.end = places[(int)clamp(last, 0.0f, (float)ROW_BINS)];
  row.middle = clamp(places[walk->next_chunk], row.begin, row.end);
  return row;
}

#ifdef EXACT
// Squared distance of the point at a place, rounded after every operation and added in the
// order of the other engines: volatile keeps compilers from fusing and reordering.
INLINE double
exactSquared(const Walk* walk, uint place)
{
  global const double* point = walk->exact + 3 * (walk->points[place] & walk->index_mask);
  const double dx = point[0] - walk->query[0], dy = point[1] - walk->query[1],
               dz = point[2] - walk->query[2];
  volatile double xx = dx * dx, yy = dy * dy, zz = dz * dz;
  volatile double xx_yy = xx + yy;
  volatile double sum = xx_yy + zz;
  return sum;
}
#endif

#endif // CENTROID
