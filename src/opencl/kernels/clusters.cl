// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Curvilinear-grid clustering, point by point: what src/clustering/host_passes.cpp does,
// bit for bit. Nothing may be fused or reordered here; the program is built without the
// options that allow it.

#ifdef cl_khr_fp64
#pragma OPENCL EXTENSION cl_khr_fp64 : enable

#define FACES 6
#define STEPS 8
#define INSIDE_CELL 255
#define NO_SLOT 0xFFFFFFFFu
#define BRICK_CELLS 512

// CellFrame and CellDirectory; the host has the same struct.
typedef struct {
  double low[3], inverse[3];
  double eye[3], axes[9];
  double tangent[2], scale[2];
  ulong bricks[2];
  int cells[4];
  int perspective;
} Grid;

static bool
locate(constant Grid* grid,
       global const double* depths,
       global const double* points,
       size_t i,
       int* cell,
       double* part)
{
  const double px = points[3 * i], py = points[3 * i + 1], pz = points[3 * i + 2];
  if (!grid->perspective) {
    const double p[3] = {px, py, pz};
    for (int a = 0; a < 3; ++a) {
      const double at = (p[a] - grid->low[a]) * grid->inverse[a];
      if (!(at >= 0 && at < 1e9))
        return false;
      cell[a] = min((int)at, grid->cells[a] - 1);
      part[a] = grid->cells[a] > 1 ? at - cell[a] : 0.5;
    }
    return true;
  }
  const double x = px - grid->eye[0], y = py - grid->eye[1], z = pz - grid->eye[2];
  const double right = grid->axes[0] * x + grid->axes[1] * y + grid->axes[2] * z;
  const double down = grid->axes[3] * x + grid->axes[4] * y + grid->axes[5] * z;
  const double depth = grid->axes[6] * x + grid->axes[7] * y + grid->axes[8] * z;
  const int layers = grid->cells[2];
  if (!(depth >= depths[0] && depth <= depths[layers]))
    return false;
  const double across = (right / depth + grid->tangent[0]) * grid->scale[0];
  const double along = (down / depth + grid->tangent[1]) * grid->scale[1];
  if (!(across >= 0 && across <= grid->cells[0] && along >= 0 && along <= grid->cells[1]))
    return false;
  // The first of the depths from the second on that is larger, or the last.
  int low = 1, high = layers;
  while (low < high) {
    const int middle = (low + high) / 2;
    if (depths[middle] > depth)
      high = middle;
    else
      low = middle + 1;
  }
  cell[0] = min((int)across, grid->cells[0] - 1);
  cell[1] = min((int)along, grid->cells[1] - 1);
  cell[2] = low - 1;
  part[0] = grid->cells[0] > 1 ? across - cell[0] : 0.5;
  part[1] = grid->cells[1] > 1 ? along - cell[1] : 0.5;
  part[2] = layers > 1 ? (depth - depths[low - 1]) / (depths[low] - depths[low - 1]) : 0.5;
  return true;
}

static ulong
brickOf(constant Grid* grid, const int* cell)
{
  return ((ulong)(cell[2] / 8) * grid->bricks[1] + (ulong)(cell[1] / 8)) *
             grid->bricks[0] +
         (ulong)(cell[0] / 8);
}

static uint
withinBrick(const int* cell)
{
  return (uint)((cell[0] & 7) | ((cell[1] & 7) << 3) | ((cell[2] & 7) << 6));
}

// How many members of a set of ranked bits are smaller.
static uint
smaller(global const uint* words, global const uint* before, ulong number)
{
  const uint lower = words[number / 32] & ((1u << (number % 32)) - 1);
  return before[number / 32] + popcount(lower);
}

static void
mark(global uint* words, ulong number)
{
  const uint bit = 1u << (number % 32);
  if ((words[number / 32] & bit) == 0)
    atomic_or(&words[number / 32], bit);
}

kernel void
markBricks(global const double* points,
           uint count,
           constant Grid* grid,
           global const double* depths,
           global uint* marked)
{
  const size_t i = get_global_id(0);
  int cell[3];
  double part[3];
  if (i < count && locate(grid, depths, points, i, cell, part))
    mark(marked, brickOf(grid, cell));
}

kernel void
markCells(global const double* points,
          uint count,
          constant Grid* grid,
          global const double* depths,
          global const uint* marked,
          global const uint* marked_before,
          global uint* occupied)
{
  const size_t i = get_global_id(0);
  int cell[3];
  double part[3];
  if (i < count && locate(grid, depths, points, i, cell, part))
    mark(occupied,
         (ulong)BRICK_CELLS * smaller(marked, marked_before, brickOf(grid, cell)) +
             withinBrick(cell));
}

static uchar
nearestFace(const double* part, double border, double step_scale)
{
  const double x = part[0] - 0.5, y = part[1] - 0.5, z = part[2] - 0.5;
  double farthest = fabs(x);
  uint face = x > 0 ? 1 : 0;
  if (fabs(y) > farthest) {
    farthest = fabs(y);
    face = y > 0 ? 3 : 2;
  }
  if (fabs(z) > farthest) {
    farthest = fabs(z);
    face = z > 0 ? 5 : 4;
  }
  const double distance = 0.5 - farthest;
  if (!(distance < border))
    return INSIDE_CELL;
  const uint step = (uint)(distance > 0 ? distance * step_scale : 0);
  return (uchar)(face * STEPS + min(step, (uint)(STEPS - 1)));
}

kernel void
findHomes(global const double* points,
          uint count,
          constant Grid* grid,
          global const double* depths,
          global const uint* marked,
          global const uint* marked_before,
          global const uint* occupied,
          global const uint* occupied_before,
          double border,
          double step_scale,
          global uint* home,
          global uint* assigned,
          global uchar* faces)
{
  const size_t i = get_global_id(0);
  if (i >= count)
    return;
  int cell[3];
  double part[3];
  if (!locate(grid, depths, points, i, cell, part)) {
    home[i] = assigned[i] = NO_SLOT;
    faces[i] = INSIDE_CELL;
    return;
  }
  home[i] = assigned[i] =
      smaller(occupied,
              occupied_before,
              (ulong)BRICK_CELLS * smaller(marked, marked_before, brickOf(grid, cell)) +
                  withinBrick(cell));
  faces[i] = nearestFace(part, border, step_scale);
}

kernel void
borderCounts(global const uint* home,
             global const uchar* faces,
             uint count,
             global uint* counts)
{
  const size_t i = get_global_id(0);
  if (i < count && faces[i] != INSIDE_CELL)
    atomic_inc(&counts[(size_t)home[i] * FACES * STEPS + faces[i]]);
}

// Adds to an integer of 64 bits, low word first, where atomics have 32.
static void
addTo(global uint* sum, long value)
{
  const uint low = (uint)value;
  const uint old = atomic_add(&sum[0], low);
  const uint high = (uint)(value >> 32) + (old + low < old ? 1 : 0);
  if (high != 0)
    atomic_add(&sum[1], high);
}

// Ten integers per slot: CellSums.
kernel void
cellSums(global const double* points,
         global const uint* assigned,
         uint count,
         global const double* origins,
         global uint* sums)
{
  const size_t i = get_global_id(0);
  if (i >= count || assigned[i] == NO_SLOT)
    return;
  const size_t slot = assigned[i];
  global const double* origin = origins + 6 * slot;
  const long x = convert_long_rte((points[3 * i] - origin[0]) * origin[3]);
  const long y = convert_long_rte((points[3 * i + 1] - origin[1]) * origin[4]);
  const long z = convert_long_rte((points[3 * i + 2] - origin[2]) * origin[5]);
  global uint* sum = sums + 20 * slot;
  addTo(sum, 1);
  addTo(sum + 2, x);
  addTo(sum + 4, y);
  addTo(sum + 6, z);
  addTo(sum + 8, x * x);
  addTo(sum + 10, x * y);
  addTo(sum + 12, x * z);
  addTo(sum + 14, y * y);
  addTo(sum + 16, y * z);
  addTo(sum + 18, z * z);
}

// Two integers per slot: FieldSum.
kernel void
fieldSums(global const int* field,
          global const uint* assigned,
          uint count,
          global uint* sums)
{
  const size_t i = get_global_id(0);
  if (i >= count || assigned[i] == NO_SLOT || field[i] == INT_MIN)
    return;
  global uint* sum = sums + 4 * (size_t)assigned[i];
  addTo(sum, 1);
  addTo(sum + 2, field[i]);
}

// The slot behind the nearest face of a point, NO_SLOT if it cannot move.
static uint
behind(size_t i,
       uint count,
       global const uint* home,
       global const uchar* faces,
       global const uint* neighbors)
{
  if (i >= count || faces[i] == INSIDE_CELL)
    return NO_SLOT;
  return neighbors[(size_t)home[i] * FACES + faces[i] / STEPS];
}

kernel void
moveBySteps(global const uint* home,
            global const uchar* faces,
            uint count,
            global const uint* neighbors,
            global const uchar* shifts,
            global uint* assigned)
{
  const size_t i = get_global_id(0);
  const uint other = behind(i, count, home, faces, neighbors);
  if (other == NO_SLOT)
    return;
  const uchar shift = shifts[(size_t)home[i] * FACES + faces[i] / STEPS];
  assigned[i] = faces[i] % STEPS < shift ? other : home[i];
}

static double
distanceTo(global const double* plane, global const double* p)
{
  const double x = (p[0] - plane[0]) * plane[3];
  const double y = (p[1] - plane[1]) * plane[4];
  const double z = (p[2] - plane[2]) * plane[5];
  return fabs((x + y) + z);
}

kernel void
moveToPlanes(global const uint* home,
             global const uchar* faces,
             uint count,
             global const uint* neighbors,
             global const double* planes,
             global const double* points,
             global uint* assigned)
{
  const size_t i = get_global_id(0);
  const uint other = behind(i, count, home, faces, neighbors);
  if (other == NO_SLOT)
    return;
  const size_t here = assigned[i], there = here == home[i] ? other : home[i];
  if (distanceTo(planes + 6 * there, points + 3 * i) <
      distanceTo(planes + 6 * here, points + 3 * i))
    assigned[i] = (uint)there;
}

kernel void
moveByField(global const uint* home,
            global const uchar* faces,
            uint count,
            global const uint* neighbors,
            global const double* means,
            global const int* field,
            global uint* assigned)
{
  const size_t i = get_global_id(0);
  const uint other = behind(i, count, home, faces, neighbors);
  if (other == NO_SLOT || field[i] == INT_MIN)
    return;
  const uint here = assigned[i], there = here == home[i] ? other : home[i];
  const double value = field[i];
  if (value < means[here] && value > means[there])
    assigned[i] = there;
}

#endif // double precision
