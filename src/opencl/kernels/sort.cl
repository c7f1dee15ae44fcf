// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Bitonic sort of 64-bit keys, ascending.
//
// The network in which every comparison puts the smaller key at the lower place: each
// merge of two sorted halves begins by comparing places that mirror each other (a flip)
// and continues with strides that halve. Missing keys count as the largest and never
// move, so any number of whole blocks can be sorted without padding.

#define BLOCK 2048 // keys that a group sorts by itself in local memory
#define GROUP 128  // its work-items
#define FUSED 8    // vectors of keys that one work-item takes through three steps

// Keys at a time: vectors on CPUs, single keys on GPUs.
#if WIDTH == 1
#define KEYS 1
typedef ulong Keys;
#define LOAD_KEYS(pointer) (*(pointer))
#define STORE_KEYS(keys, pointer) (*(pointer) = (keys))
#define REVERSED(keys) (keys)
#else
#define KEYS 8
typedef ulong8 Keys;
#define LOAD_KEYS(pointer) vload8(0, pointer)
#define STORE_KEYS(keys, pointer) vstore8(keys, 0, pointer)
#define REVERSED(keys) (keys).s76543210
#endif

INLINE void
order(Keys* a, Keys* b)
{
  const Keys low = min(*a, *b);
  *b = max(*a, *b);
  *a = low;
}

#if KEYS == 8
// Compares every key with the one in its place in `partners`; the lanes of `upper` keep
// the larger.
#define ORDER_LANES(keys, partners, upper)                                               \
  keys = select(min(keys, partners), max(keys, partners), (ulong8)upper)
#define UPPER_4 (0, 0, 0, 0, ~0UL, ~0UL, ~0UL, ~0UL)
#define UPPER_2 (0, 0, ~0UL, ~0UL, 0, 0, ~0UL, ~0UL)
#define UPPER_1 (0, ~0UL, 0, ~0UL, 0, ~0UL, 0, ~0UL)
#endif

// The steps of strides below KEYS.
INLINE Keys
mergedWithin(Keys keys)
{
#if KEYS == 8
  ORDER_LANES(keys, keys.s45670123, UPPER_4);
  ORDER_LANES(keys, keys.s23016745, UPPER_2);
  ORDER_LANES(keys, keys.s10325476, UPPER_1);
#endif
  return keys;
}

// The whole network of KEYS keys.
INLINE Keys
sortedWithin(Keys keys)
{
#if KEYS == 8
  ORDER_LANES(keys, keys.s10325476, UPPER_1);
  ORDER_LANES(keys, keys.s32107654, UPPER_2);
  ORDER_LANES(keys, keys.s10325476, UPPER_1);
  ORDER_LANES(keys, keys.s76543210, UPPER_4);
  ORDER_LANES(keys, keys.s23016745, UPPER_2);
  ORDER_LANES(keys, keys.s10325476, UPPER_1);
#endif
  return keys;
}

// Steps of the strides from `stride` down inside a block. Ends with a barrier.
INLINE void
mergeBlock(local ulong* block, uint stride)
{
  for (; stride >= KEYS; stride /= 2) {
    for (uint pair = get_local_id(0); pair < BLOCK / KEYS / 2; pair += GROUP) {
      const uint at = KEYS * pair;
      const uint low = 2 * at - (at & (stride - 1));
      Keys a = LOAD_KEYS(block + low), b = LOAD_KEYS(block + low + stride);
      order(&a, &b);
      STORE_KEYS(a, block + low);
      STORE_KEYS(b, block + low + stride);
    }
    barrier(CLK_LOCAL_MEM_FENCE);
  }
}

// Sorts every block.
kernel __attribute__((reqd_work_group_size(GROUP, 1, 1))) void
sortBlocks(global ulong* keys)
{
  local ulong block[BLOCK];
  global ulong* mine = keys + get_group_id(0) * BLOCK;
  for (uint at = KEYS * get_local_id(0); at < BLOCK; at += KEYS * GROUP)
    STORE_KEYS(sortedWithin(LOAD_KEYS(mine + at)), block + at);
  barrier(CLK_LOCAL_MEM_FENCE);
  for (uint size = 2 * KEYS; size <= BLOCK; size *= 2) {
    for (uint pair = get_local_id(0); pair < BLOCK / KEYS / 2; pair += GROUP) {
      const uint at = KEYS * pair, offset = at & (size / 2 - 1);
      const uint low = 2 * at - offset, high = 2 * (at - offset) + size - offset - KEYS;
      Keys a = LOAD_KEYS(block + low), b = REVERSED(LOAD_KEYS(block + high));
      order(&a, &b);
      STORE_KEYS(a, block + low);
      STORE_KEYS(REVERSED(b), block + high);
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    mergeBlock(block, size / 4);
    for (uint at = KEYS * get_local_id(0); at < BLOCK; at += KEYS * GROUP)
      STORE_KEYS(mergedWithin(LOAD_KEYS(block + at)), block + at);
    barrier(CLK_LOCAL_MEM_FENCE);
  }
  for (uint at = KEYS * get_local_id(0); at < BLOCK; at += KEYS * GROUP)
    STORE_KEYS(LOAD_KEYS(block + at), mine + at);
}

// Ends a merge: the strides that stay inside a block.
kernel __attribute__((reqd_work_group_size(GROUP, 1, 1))) void
mergeBlocks(global ulong* keys)
{
  local ulong block[BLOCK];
  global ulong* mine = keys + get_group_id(0) * BLOCK;
  for (uint at = KEYS * get_local_id(0); at < BLOCK; at += KEYS * GROUP)
    STORE_KEYS(LOAD_KEYS(mine + at), block + at);
  barrier(CLK_LOCAL_MEM_FENCE);
  mergeBlock(block, BLOCK / 2);
  for (uint at = KEYS * get_local_id(0); at < BLOCK; at += KEYS * GROUP)
    STORE_KEYS(mergedWithin(LOAD_KEYS(block + at)), mine + at);
}

INLINE Keys
loadOrLargest(global const ulong* keys, uint place, uint count)
{
  const Keys largest = ~0UL;
  return place < count ? LOAD_KEYS(keys + place) : largest;
}

INLINE void
storeIfThere(Keys value, global ulong* keys, uint place, uint count)
{
  if (place < count)
    STORE_KEYS(value, keys + place);
}

// Up to two steps on `vectors` that are consecutive or apart.
INLINE void
halveStrides(Keys* v, uint steps)
{
  if (steps > 0) {
    order(v, v + 2);
    order(v + 1, v + 3);
  }
  if (steps > 1) {
    order(v, v + 1);
    order(v + 2, v + 3);
  }
}

// Begins the merge of two sorted halves of `size` keys: the flip, and up to two more steps.
kernel void
flip(global ulong* keys, uint count, uint size, uint steps)
{
  const uint at = KEYS * get_global_id(0), gap = size / FUSED;
  const uint offset = at & (gap - 1), base = (at - offset) * FUSED;
  const uint mirrored = gap - offset - KEYS;
  if (base + offset >= count)
    return;
  Keys low[FUSED / 2], high[FUSED / 2];
  for (uint k = 0; k < FUSED / 2; ++k) {
    low[k] = loadOrLargest(keys, base + k * gap + offset, count);
    high[k] = REVERSED(
        loadOrLargest(keys, base + (k + FUSED / 2) * gap + mirrored, count));
  }
  for (uint k = 0; k < FUSED / 2; ++k)
    order(low + k, high + FUSED / 2 - 1 - k);
  halveStrides(low, steps - 1);
  halveStrides(high, steps - 1);
  for (uint k = 0; k < FUSED / 2; ++k) {
    storeIfThere(low[k], keys, base + k * gap + offset, count);
    storeIfThere(
        REVERSED(high[k]), keys, base + (k + FUSED / 2) * gap + mirrored, count);
  }
}

// Continues a merge: up to three steps, the first with the given stride.
kernel void
merge(global ulong* keys, uint count, uint stride, uint steps)
{
  const uint at = KEYS * get_global_id(0), gap = stride / (FUSED / 2);
  const uint offset = at & (gap - 1), base = (at - offset) * FUSED + offset;
  if (base >= count)
    return;
  Keys v[FUSED];
  for (uint k = 0; k < FUSED; ++k)
    v[k] = loadOrLargest(keys, base + k * gap, count);
  for (uint k = 0; k < FUSED / 2; ++k)
    order(v + k, v + k + FUSED / 2);
  halveStrides(v, steps - 1);
  halveStrides(v + FUSED / 2, steps - 1);
  for (uint k = 0; k < FUSED; ++k)
    storeIfThere(v[k], keys, base + k * gap, count);
}
