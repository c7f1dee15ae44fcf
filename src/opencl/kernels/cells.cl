// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Cells and the runs of sorted points around them.
//
// A cell is as wide as the largest radius, so a neighborhood lies in 3 x 3 x 3 cells.
// Along x a cell is divided into bins. The key of a point is the number of its bin, counted
// along x, then y, then z, and below it the point's index: a row of cells is one run of
// sorted points, and so is any stretch of its bins.

#define REACH 1 // cells that a neighborhood reaches beyond its own
#define SIDE (2 * REACH + 1)
#define ROWS (SIDE * SIDE)
#define BINS 4                        // of a cell
#define ROW_BINS (SIDE * BINS)        // of a row of cells
#define ROW_PLACES (ROW_BINS + 1)     // their borders
#define TABLE_SIZE (ROWS * ROW_PLACES) // of a cell

// How keys are made: cells along x and y, bits of the index.
typedef struct {
  uint nx, ny, index_bits;
} KeyLayout;

INLINE ulong
keyOf(KeyLayout layout, int x, int y, int z, uint bin)
{
  return ((((ulong)z * layout.ny + (ulong)y) * layout.nx + (ulong)x) * BINS + bin)
         << layout.index_bits;
}

// Number of the cell that a key lies in.
INLINE ulong
cellOf(KeyLayout layout, ulong key)
{
  return (key >> layout.index_bits) / BINS;
}

kernel void
cellKeys(global const int4* cells,
         global const float* offsets,
         uint count,
         float inverse_cell_size,
         KeyLayout layout,
         global ulong* keys)
{
  const uint i = get_global_id(0);
  ulong key = ~0UL;
  if (i < count) {
    const int bin = (int)(offsets[3 * i] * inverse_cell_size * BINS);
    const int4 cell = cells[i];
    key = keyOf(layout, cell.x, cell.y, cell.z, (uint)clamp(bin, 0, BINS - 1)) | i;
  }
  keys[i] = key;
}

// First place in the sorted keys, from `begin` on, whose key is not below the given one.
INLINE uint
lowerBound(global const ulong* keys, uint begin, uint end, ulong key)
{
  uint count = end - begin;
  while (count > 0) {
    const uint half_count = count / 2;
    if (keys[begin + half_count] < key) {
      begin += half_count + 1;
      count -= half_count + 1;
    }
    else
      count = half_count;
  }
  return begin;
}

// Gives every cell that holds a query its own slot, and stores the slots of queries.
// The numbering differs from run to run, the content of slots does not.
kernel void
assignSlots(global const ulong* queries,
            uint count,
            KeyLayout layout,
            global uint* query_slot,
            global uint* slot_place,
            global uint* slots)
{
  uint place = get_global_id(0);
  if (place >= count)
    return;
  const ulong cell = cellOf(layout, queries[place]);
  if (place > 0 && cellOf(layout, queries[place - 1]) == cell)
    return;
  const uint slot = atomic_inc(slots);
  slot_place[slot] = place;
  for (; place < count && cellOf(layout, queries[place]) == cell; ++place)
    query_slot[place] = slot;
}

// For every slot and each of the rows around its cell: where the bins of the row begin
// among the sorted points, and where the last one ends.
kernel void
cellTable(global const ulong* queries,
          global const uint* slot_place,
          uint slots,
          KeyLayout layout,
          global const ulong* points,
          uint count,
          global uint* table)
{
  const uint slot = get_global_id(0) / ROWS;
  if (slot >= slots)
    return;
  const uint row = get_global_id(0) % ROWS;
  const ulong cell = cellOf(layout, queries[slot_place[slot]]);
  // The host leaves the outermost cells of every axis empty, so no step wraps around.
  const long y = (long)(row % SIDE) - REACH, z = (long)(row / SIDE) - REACH;
  const ulong first_cell =
      (ulong)((long)cell + (z * (long)layout.ny + y) * (long)layout.nx - REACH);
  const ulong first_bin = first_cell * BINS;
  global uint* places = table + TABLE_SIZE * slot + ROW_PLACES * row;
  uint place = lowerBound(points, 0, count, first_bin << layout.index_bits);
  const uint end =
      lowerBound(points, place, count, (first_bin + ROW_BINS) << layout.index_bits);
  for (uint bin = 0; bin < ROW_BINS; ++bin) {
    place = lowerBound(points, place, end, (first_bin + bin) << layout.index_bits);
    places[bin] = place;
  }
  places[ROW_BINS] = end;
}

// Positions along x are relative to a chunk of cells, which keeps them exact in float.
#define CHUNK_BITS 5
#define CHUNK_MASK ((1 << CHUNK_BITS) - 1)

// The position of a point or query along x relative to its chunk: rounded once, so that
// coincident points have the same.
INLINE float
placeInChunk(float offset, int cell, float cell_size)
{
  return fma(cell_size, (float)(cell & CHUNK_MASK), offset);
}

// Positions in sorted order: x relative to its chunk, y and z to their cell.
kernel void
gatherPoints(global const ulong* points,
             uint count,
             KeyLayout layout,
             global const float* offsets,
             global const int4* cells,
             float cell_size,
             global float* x,
             global float* y,
             global float* z)
{
  const uint place = get_global_id(0);
  if (place >= count)
    return;
  const ulong index_mask = ((ulong)1 << layout.index_bits) - 1;
  const uint i = (uint)(points[place] & index_mask);
  x[place] = placeInChunk(offsets[3 * i], cells[i].x, cell_size);
  y[place] = offsets[3 * i + 1];
  z[place] = offsets[3 * i + 2];
}
