// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "laz_points.h"

#include <algorithm>

#include <linelet/support/threads.h>

#include "io/laz/chunk_table.h"
#include "io/laz/chunk_writer.h"
#include "io/source.h"
#include "support/parallel_failure.h"

namespace linelet::io {

namespace {

std::string_view
textOf(const std::vector<std::uint8_t>& bytes)
{
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

} // namespace

std::vector<std::vector<std::uint8_t>>
encodeChunks(
    const laz::Layout& layout,
    std::size_t count,
    const std::function<std::string(std::size_t first, std::size_t number)>& records,
    unsigned threads)
{
  const std::size_t size = layout.chunk_size;
  std::vector<std::vector<std::uint8_t>> chunks((count + size - 1) / size);
  ParallelFailure failure;
#pragma omp parallel for schedule(dynamic) num_threads(threadCount(threads))
  for (std::size_t i = 0; i < chunks.size(); ++i)
    failure.guard([&] {
      const std::size_t number = std::min(size, count - i * size);
      std::string text = records(i * size, number);
      chunks[i] =
          laz::writeChunk(layout, reinterpret_cast<std::uint8_t*>(text.data()), number);
    });
  failure.rethrow();
  return chunks;
}

void
LazPoints::encode(
    std::size_t count,
    const std::function<std::string(std::size_t first, std::size_t number)>& records)
{
  chunks_ = encodeChunks(layout_, count, records, threads_);
  std::vector<std::uint32_t> sizes;
  for (const auto& chunk : chunks_)
    sizes.push_back(static_cast<std::uint32_t>(chunk.size()));
  table_ = laz::writeChunkTable(sizes);
}

std::uint64_t
LazPoints::size() const
{
  std::uint64_t size = 8 + table_.size();
  for (const auto& chunk : chunks_)
    size += chunk.size();
  return size;
}

void
LazPoints::write(OutputFile& file, std::uint64_t place) const
{
  std::string begin(8, '\0'); // place of the chunk table
  store<std::uint64_t>(begin.data(), place + size() - table_.size());
  file.write(begin);
  for (const auto& chunk : chunks_)
    file.write(textOf(chunk));
  file.write(textOf(table_));
}

} // namespace linelet::io
