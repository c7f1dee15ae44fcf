// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "key_sort.h"

#include <algorithm>
#include <array>

#include "support/huge_pages.h"

namespace linelet::grid {

namespace {

// By hand: VQSort of keys packed with their places is 1.3 to 2.8 times as fast, but
// uses only one thread, and twice the width where they do not fit 64 bits.
constexpr int digit_bits = 11;
constexpr std::size_t digits = std::size_t{1} << digit_bits;
using Histogram = std::array<std::size_t, digits>;

std::size_t
digit(std::uint64_t key, int shift)
{
  return static_cast<std::size_t>(key >> shift) & (digits - 1);
}

} // namespace

void
sortByKey(std::vector<std::uint64_t>& keys, Indices& values, int bits, int threads)
{
  const std::size_t count = keys.size();
  std::vector<std::uint64_t> other_keys;
  Indices other_values;
  reserveHuge(other_keys, count);
  reserveHuge(other_values, count);
  other_keys.resize(count);
  other_values.resize(count);
  // Every part is counted and moved on its own; parts follow each other within a digit.
  const auto parts = static_cast<std::size_t>(std::max(threads, 1));
  std::vector<Histogram> place(parts);
  for (int shift = 0; shift < bits; shift += digit_bits) {
#pragma omp parallel for num_threads(threads) schedule(static, 1)
    for (std::size_t p = 0; p < parts; ++p) {
      place[p].fill(0);
      for (std::size_t i = count * p / parts; i < count * (p + 1) / parts; ++i)
        ++place[p][digit(keys[i], shift)];
    }
    std::size_t next = 0;
    for (std::size_t d = 0; d < digits; ++d)
      for (std::size_t p = 0; p < parts; ++p) {
        const std::size_t entries = place[p][d];
        place[p][d] = next;
        next += entries;
      }
#pragma omp parallel for num_threads(threads) schedule(static, 1)
    for (std::size_t p = 0; p < parts; ++p)
      for (std::size_t i = count * p / parts; i < count * (p + 1) / parts; ++i) {
        const std::size_t to = place[p][digit(keys[i], shift)]++;
        other_keys[to] = keys[i];
        other_values[to] = values[i];
      }
    keys.swap(other_keys);
    values.swap(other_values);
  }
}

} // namespace linelet::grid
