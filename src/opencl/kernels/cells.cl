// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Cells and the runs of sorted points around them.
//
// A cell is half as wide as the largest radius, so a neighbourhood lies in 5 x 5 x 5 cells.
// The key of a cell orders by z, y, x: five cells beside each other along x, a row, are one
// run of sorted points.

#define REACH 2 // cells that a neighbourhood reaches beyond its own
#define SIDE (2 * REACH + 1)
#define ROWS (SIDE * SIDE)
#define KEY_BITS 21
#define PADDING_KEY 0xffffffffffffffffUL

ulong
keyOf(int4 cell)
{
  return ((ulong)cell.z << (2 * KEY_BITS)) | ((ulong)cell.y << KEY_BITS) | (ulong)cell.x;
}

int4
cellOf(ulong key)
{
  const ulong mask = ((ulong)1 << KEY_BITS) - 1;
  return (int4)((int)(key & mask),
                (int)((key >> KEY_BITS) & mask),
                (int)(key >> (2 * KEY_BITS)),
                0);
}

kernel void
cellKeys(global const int4* cells, uint count, global Entry* entries)
{
  const uint i = get_global_id(0);
  entries[i].key = i < count ? keyOf(cells[i]) : PADDING_KEY;
  entries[i].index = i;
  entries[i].unused = 0;
}

// First place in the sorted entries whose key is not below the given one.
uint
lowerBound(global const Entry* entries, uint count, ulong key)
{
  uint begin = 0;
  while (count > 0) {
    const uint half_count = count / 2;
    if (entries[begin + half_count].key < key) {
      begin += half_count + 1;
      count -= half_count + 1;
    }
    else
      count = half_count;
  }
  return begin;
}

// Gives every cell that holds a query a slot of its own; `cell_slot` at the place of the
// first query of the cell says which. The numbering differs from run to run, what is
// stored under it does not.
kernel void
assignSlots(global const Entry* queries,
            uint count,
            global uint* cell_slot,
            global uint* slot_place,
            global uint* slots)
{
  const uint place = get_global_id(0);
  if (place >= count || (place > 0 && queries[place - 1].key == queries[place].key))
    return;
  const uint slot = atomic_inc(slots);
  cell_slot[place] = slot;
  slot_place[slot] = place;
}

// For every slot and each of the rows around its cell: where the run of points begins,
// where the next chunk along x begins inside it, and where it ends. Positions along x are
// relative to a chunk of cells, which keeps them exact in float.
#define CHUNK_BITS 6

kernel void
neighbourRuns(global const Entry* queries,
              global const uint* slot_place,
              uint slots,
              global const Entry* points,
              uint count,
              global uint* runs)
{
  const uint slot = get_global_id(0) / ROWS;
  if (slot >= slots)
    return;
  const uint row = get_global_id(0) % ROWS;
  const int4 cell = cellOf(queries[slot_place[slot]].key);
  const int x = max(cell.x - REACH, 0), y = cell.y + (int)(row % SIDE) - REACH,
            z = cell.z + (int)(row / SIDE) - REACH;
  global uint* run = runs + 3 * (ROWS * slot + row);
  if (y < 0 || z < 0) {
    run[0] = run[1] = run[2] = 0;
    return;
  }
  // The host leaves the last places of every axis free, so x never carries into y.
  const ulong row_key = keyOf((int4)(0, y, z, 0));
  const int x_end = cell.x + REACH + 1;
  const int next_chunk = ((x >> CHUNK_BITS) + 1) << CHUNK_BITS;
  const uint begin = lowerBound(points, count, row_key + (ulong)x);
  const uint end = begin + lowerBound(points + begin, count - begin, row_key + (ulong)x_end);
  run[0] = begin;
  run[1] = next_chunk < x_end
               ? begin + lowerBound(points + begin, end - begin, row_key + (ulong)next_chunk)
               : end;
  run[2] = end;
}

// Positions in sorted order: x relative to its chunk, y and z to their cell; beside them
// the exact ones, where the device computes in double.
kernel void
gatherPoints(global const Entry* entries,
             uint count,
             global const float* offsets,
             global const int4* cells,
             float cell_size,
             global float* x,
             global float* y,
             global float* z
#ifdef EXACT
             ,
             global const double* positions,
             global double* exact
#endif
)
{
  const uint place = get_global_id(0);
  if (place >= count)
    return;
  const uint i = entries[place].index;
  const int chunk_mask = (1 << CHUNK_BITS) - 1;
  x[place] = offsets[3 * i] + cell_size * (float)(cells[i].x & chunk_mask);
  y[place] = offsets[3 * i + 1];
  z[place] = offsets[3 * i + 2];
#ifdef EXACT
  for (uint axis = 0; axis < 3; ++axis)
    exact[3 * place + axis] = positions[3 * i + axis];
#endif
}
