// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "chunk_table.h"

#include <algorithm>

#include "bytes.h"
#include "chunk_reader.h"
#include "decoder.h"
#include "encoder.h"
#include "integers.h"

namespace linelet::laz {

namespace {

// No point takes less than 1/2048 of a byte: its three cheapest symbols, by models
// whose counts add up to 2^15, are a 300th of a bit each.
constexpr std::uint64_t most_points_per_byte = 2048;

// Scans take several bytes per point. If a file claims more points than this, they are
// decoded once before anything is allocated for them.
constexpr std::uint64_t credible_points_per_byte = 16;

/** Offset of the table as stated by the file; 0: none was written. */
std::uint64_t
placeOfTable(std::string_view file, std::size_t points_at)
{
  auto place = load<std::uint64_t>(beginOf(file) + points_at);
  // A writer that cannot seek states it in the last bytes of the file.
  if (place == ~std::uint64_t{0})
    place = load<std::uint64_t>(beginOf(file) + file.size() - 8);
  const bool none = place == points_at || place == 0 || place == ~std::uint64_t{0};
  return none ? 0 : place;
}

/** Adds a chunk at \a at of \a bytes for the next \a count points. */
void
addChunk(ChunkTable& table,
         std::size_t at,
         std::size_t bytes,
         bool exact,
         std::uint64_t count)
{
  const auto points = static_cast<std::size_t>(count);
  if (points == 0)
    return;
  table.chunks.push_back({at, bytes, exact, table.points, points});
  table.points += points;
}

bool
isPossible(std::uint64_t points, std::size_t bytes, std::size_t record_length)
{
  return points == 0 || (bytes >= record_length &&
                         points <= most_points_per_byte * std::uint64_t{bytes});
}

/** The chunks listed in the table at \a place; \a problem: why it is not a table. */
ChunkTable
readTable(std::string_view file,
          std::size_t begin,
          std::size_t place,
          std::uint64_t count,
          const Layout& layout)
{
  ChunkTable table;
  const std::uint8_t* at = beginOf(file) + place;
  const std::size_t entries = load<std::uint32_t>(at + 4);
  // Every chunk holds at least one raw record.
  if (load<std::uint32_t>(at) != 0 ||
      entries > (place - begin) / layout.recordLength()) {
    table.problem = "its chunk table is damaged";
    return table;
  }
  Decoder decoder(at + 8, beginOf(file) + file.size());
  IntegerModel<32, 2> numbers;
  const bool variable = layout.chunk_size == Layout::variable;
  std::uint32_t points = 0, bytes = 0;
  for (std::size_t i = 0; i < entries && table.points < count; ++i) {
    if (variable)
      points = numbers.code(decoder, points, 0, 0);
    else
      points = static_cast<std::uint32_t>(
          std::min<std::uint64_t>(layout.chunk_size, count - table.points));
    bytes = numbers.code(decoder, bytes, 0, 1);
    if (decoder.overrun() || bytes > place - begin ||
        !isPossible(points, bytes, layout.recordLength())) {
      table.problem = "its chunk table is damaged";
      return table;
    }
    addChunk(table, begin, bytes, true, points);
    begin += bytes;
  }
  if (table.points < count)
    table.problem = "its chunk table ends early";
  return table;
}

/** The chunks, found one by one: layered chunks state their size, others must be
 * decoded. */
ChunkTable
findChunks(std::string_view file,
           std::size_t begin,
           std::uint64_t count,
           const Layout& layout)
{
  ChunkTable table;
  const std::size_t length = layout.recordLength();
  while (table.points < count && file.size() - begin >= length) {
    const std::string_view rest = file.substr(begin);
    const auto points =
        std::min<std::uint64_t>(layout.chunk_size, count - table.points);
    if (!isPossible(points, rest.size(), length))
      break;
    std::size_t bytes = 0;
    try {
      bytes = layout.layered()
                  ? layeredChunkSize(layout, rest).bytes
                  : skipChunk(layout, rest, static_cast<std::size_t>(points));
    }
    catch (const Error&) {
      break;
    }
    addChunk(table, begin, bytes, true, points);
    begin += bytes;
  }
  if (table.points < count)
    table.problem = "its chunk table is missing, and the file ends early";
  return table;
}

/** Checks by decoding that a chunk holds its points, if there are implausibly many. */
void
prove(std::string_view file, const Chunk& chunk, const Layout& layout)
{
  if (chunk.count > credible_points_per_byte * chunk.bytes)
    skipChunk(layout, file.substr(chunk.at, chunk.bytes), chunk.count);
}

ChunkTable
findTable(std::string_view file,
          std::size_t points_at,
          std::uint64_t count,
          const Layout& layout)
{
  ChunkTable table;
  const bool pointwise = layout.compressor == Layout::Pointwise;
  const std::size_t begin = points_at + (pointwise ? 0 : 8);
  if (file.size() < begin)
    throw Error("the file ends before its compressed points");
  if (pointwise) {
    const std::size_t bytes = file.size() - begin;
    if (!isPossible(count, bytes, layout.recordLength()))
      throw Error(std::to_string(count) + " points cannot be in the " +
                  std::to_string(bytes) + " bytes of the file that may hold them");
    addChunk(table, begin, bytes, false, count);
    return table;
  }
  const std::uint64_t place = placeOfTable(file, points_at);
  if (place == 0) {
    if (layout.chunk_size == Layout::variable)
      throw Error(
          "its chunk table is missing, without which chunks of any size are not "
          "found");
    return findChunks(file, begin, count, layout);
  }
  if (place >= begin && place <= file.size() - 8)
    table = readTable(file, begin, static_cast<std::size_t>(place), count, layout);
  else
    table.problem = "its chunk table at byte " + std::to_string(place) +
                    " is outside of the file of " + std::to_string(file.size()) +
                    " bytes";
  if (table.problem.empty() || layout.chunk_size == Layout::variable)
    return table;
  const std::string problem = std::move(table.problem);
  table = findChunks(file, begin, count, layout);
  table.problem = problem;
  return table;
}

} // namespace

ChunkTable
readChunkTable(std::string_view file,
               std::size_t points_at,
               std::uint64_t count,
               const Layout& layout)
{
  if (count == 0)
    return {};
  ChunkTable table = findTable(file, points_at, count, layout);
  for (const Chunk& chunk : table.chunks)
    prove(file, chunk, layout);
  return table;
}

void
checkChunk(std::string_view file, const Chunk& chunk, const Layout& layout)
{
  if (chunk.at > file.size() || chunk.bytes > file.size() - chunk.at ||
      !isPossible(chunk.count, chunk.bytes, layout.recordLength()))
    throw Error("its index has " + std::to_string(chunk.count) + " points in " +
                std::to_string(chunk.bytes) + " bytes at byte " +
                std::to_string(chunk.at) + ", which cannot be");
  prove(file, chunk, layout);
}

std::vector<std::uint8_t>
writeChunkTable(const std::vector<std::uint32_t>& sizes)
{
  std::vector<std::uint8_t> table(8);
  store(&table[4], static_cast<std::uint32_t>(sizes.size()));
  Encoder encoder;
  IntegerModel<32, 2> numbers;
  std::uint32_t last = 0;
  for (const std::uint32_t size : sizes) {
    numbers.code(encoder, last, size, 1);
    last = size;
  }
  const std::vector<std::uint8_t> entries = encoder.finish();
  table.insert(table.end(), entries.begin(), entries.end());
  return table;
}

} // namespace linelet::laz
