// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "cell_directory.h"

#include <algorithm>

namespace linelet::clustering {

void
RankedBits::rank()
{
  before.resize(words.size());
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    before[i] = sum;
    sum += static_cast<std::uint32_t>(bitCount(words[i]));
  }
  count = sum;
}

CellDirectory::CellDirectory(const Cell& cells) : cells_(cells)
{
  for (std::size_t a = 0; a < 3; ++a)
    bricks_[a] = (static_cast<std::uint64_t>(cells[a]) + 7) / 8;
  marked.words.resize((bricks_[0] * bricks_[1] * bricks_[2] + 31) / 32);
}

bool
CellDirectory::markAll(std::size_t points)
{
  constexpr std::size_t cells_of_word = 32, few = 1U << 16;
  if (keys() / cells_of_word > points + few)
    return false;
  std::fill(marked.words.begin(), marked.words.end(), ~0U);
  marked.words.back() >>= marked.words.size() * 32 - keys() / brick_cells;
  marked.rank();
  all_marked_ = true;
  return true;
}

void
CellDirectory::fillWith(const std::vector<std::vector<std::uint64_t>>& keys)
{
  for (const auto& some : keys)
    for (const std::uint64_t key : some)
      marked.add(key / brick_cells);
  marked.rank();
  occupied.words.assign(marked.count * brick_cells / 32, 0);
  for (const auto& some : keys)
    for (const std::uint64_t key : some)
      occupied.add(bit(key));
  occupied.rank();
}

Index
CellDirectory::find(const Cell& cell) const
{
  for (std::size_t a = 0; a < 3; ++a)
    if (cell[a] < 0 || cell[a] >= cells_[a])
      return none;
  if (!marked.has(brick(cell)))
    return none;
  const std::uint64_t number = bit(keyOf(cell));
  return occupied.has(number) ? occupied.smaller(number) : none;
}

std::vector<Cell>
CellDirectory::all() const
{
  std::vector<Cell> cells;
  cells.reserve(slots());
  std::uint64_t place = 0; // of the marked brick
  const auto part = [](std::uint64_t number) {
    return static_cast<std::int32_t>(number);
  };
  for (std::uint64_t number = 0; number < marked.words.size() * 32; ++number) {
    if (marked.words[number / 32] == 0)
      number |= 31;
    if (!marked.has(number))
      continue;
    const Cell corner = {part(number % bricks_[0] * 8),
                         part(number / bricks_[0] % bricks_[1] * 8),
                         part(number / bricks_[0] / bricks_[1] * 8)};
    for (std::uint32_t inside = 0; inside < brick_cells; ++inside) {
      const std::uint64_t bit_number = place * brick_cells + inside;
      if (occupied.words[bit_number / 32] == 0)
        inside |= 31;
      else if (occupied.has(bit_number))
        cells.push_back({corner[0] + part(inside & 7),
                         corner[1] + part((inside >> 3) & 7),
                         corner[2] + part(inside >> 6)});
    }
    ++place;
  }
  return cells;
}

} // namespace linelet::clustering
