// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// Bitonic sort of (key, index) entries, ascending by key and then by index, so that the
// order is the same on every device. The number of entries is a power of two and at
// least 2 * BLOCK; padding carries the largest key.

typedef struct {
  ulong key;
  uint index;
  uint unused;
} Entry;

#define BLOCK 256 // work-items of a group; each group sorts 2 * BLOCK entries by itself

bool
follows(Entry a, Entry b)
{
  return a.key > b.key || (a.key == b.key && a.index > b.index);
}

// Orders the pair (i, i + stride) inside a bitonic sequence of the given size.
void
orderPair(local Entry* block, uint i, uint stride, bool descending)
{
  const Entry a = block[i], b = block[i + stride];
  if (follows(a, b) != descending) {
    block[i] = b;
    block[i + stride] = a;
  }
}

// Runs the steps first_size .. last_size of the network as far as they stay inside a
// block: for a size above the block only the strides that fit.
kernel void
sortBlocks(global Entry* entries, uint first_size, uint last_size)
{
  local Entry block[2 * BLOCK];
  const uint item = get_local_id(0);
  const uint base = get_group_id(0) * 2 * BLOCK;
  block[item] = entries[base + item];
  block[item + BLOCK] = entries[base + item + BLOCK];
  for (uint size = first_size; size <= last_size; size *= 2) {
    for (uint stride = min(size / 2, (uint)BLOCK); stride > 0; stride /= 2) {
      barrier(CLK_LOCAL_MEM_FENCE);
      const uint i = 2 * item - (item & (stride - 1));
      orderPair(block, i, stride, ((base + i) & size) != 0);
    }
  }
  barrier(CLK_LOCAL_MEM_FENCE);
  entries[base + item] = block[item];
  entries[base + item + BLOCK] = block[item + BLOCK];
}

// One step whose stride is larger than a block.
kernel void
sortStep(global Entry* entries, uint size, uint stride)
{
  const uint item = get_global_id(0);
  const uint i = 2 * item - (item & (stride - 1));
  const Entry a = entries[i], b = entries[i + stride];
  if (follows(a, b) != ((i & size) != 0)) {
    entries[i] = b;
    entries[i + stride] = a;
  }
}
