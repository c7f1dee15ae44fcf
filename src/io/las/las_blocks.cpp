// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "las_blocks.h"

#include <algorithm>

#include <linelet/support/threads.h>

#include "io/laz/chunk_reader.h"
#include "support/parallel_failure.h"

namespace linelet::io {

namespace {

std::vector<laz::Chunk>
plainBlocks(const LasHeader& header)
{
  std::vector<laz::Chunk> blocks;
  for (std::size_t first = 0; first < header.count; first += block_points) {
    const std::size_t count = std::min(block_points, header.count - first);
    blocks.push_back({header.points_at + first * header.record_length,
                      count * header.record_length,
                      true,
                      first,
                      count});
  }
  return blocks;
}

std::vector<laz::Chunk>
findChunks(const Source& source, const LasOrigin& origin, LasHeader& header)
{
  try {
    laz::ChunkTable table = laz::readChunkTable(
        source.bytes, header.points_at, header.count, *origin.compression);
    if (!table.problem.empty())
      source.endsEarly(table.problem + ": of " + std::to_string(header.count) +
                       " points that the header names, " +
                       std::to_string(table.points) + " are found");
    header.count = table.points;
    return std::move(table.chunks);
  }
  catch (const laz::Error& error) {
    source.fail(error.what());
  }
}

} // namespace

LasBlocks::LasBlocks(const Source& source, const LasOrigin& origin, LasHeader& header)
    : source_(source),
      layout_(origin.compression),
      stride_(header.record_length),
      blocks_(layout_ ? findChunks(source, origin, header) : plainBlocks(header))
{
}

LasBlocks::LasBlocks(const Source& source,
                     const LasOrigin& origin,
                     const LasHeader& header,
                     std::vector<laz::Chunk> chunks)
    : source_(source),
      layout_(origin.compression),
      stride_(header.record_length),
      blocks_(std::move(chunks))
{
  try {
    for (const laz::Chunk& chunk : blocks_)
      laz::checkChunk(source.bytes, chunk, *layout_);
  }
  catch (const laz::Error& error) {
    source.fail(error.what());
  }
}

void
LasBlocks::keep(std::size_t first, std::size_t behind)
{
  std::vector<laz::Chunk> kept;
  std::size_t place = 0;
  for (laz::Chunk block : blocks_)
    if (block.first >= first && block.first < behind) {
      block.first = place;
      place += block.count;
      kept.push_back(block);
    }
  blocks_ = std::move(kept);
}

const char*
LasBlocks::firstRecord() const
{
  // The first record of a chunk is not compressed.
  return blocks_.empty() ? nullptr : source_.bytes.data() + blocks_.front().at;
}

void
LasBlocks::load(const laz::Chunk& chunk, std::string& records, laz::Fields wanted) const
{
  records.resize(chunk.count * stride_);
  const auto name = [&] {
    return "the points from number " + std::to_string(chunk.first + 1) +
           " on, at byte " + std::to_string(chunk.at) + ": ";
  };
  std::size_t used = 0;
  try {
    used = laz::readChunk(*layout_,
                          source_.bytes.substr(chunk.at, chunk.bytes),
                          chunk.count,
                          reinterpret_cast<std::uint8_t*>(records.data()),
                          wanted);
  }
  catch (const laz::Error& error) {
    source_.fail(name() + error.what());
  }
  if (chunk.exact && used != chunk.bytes)
    source_.fail(name() + "compressed data of " + std::to_string(chunk.bytes) +
                 " bytes, of which the points take " + std::to_string(used) +
                 "; the file is damaged");
}

void
LasBlocks::forEach(
    laz::Fields wanted,
    const std::function<void(std::size_t number, const RecordBlock& block)>& use,
    const std::function<bool(const RecordBlock& block)>& worth) const
{
  ParallelFailure failure;
  wanted |= laz::field::z;
  const bool layered = layout_ && layout_->layered();
#pragma omp parallel num_threads(threadCount(source_.options.threads))
  {
    std::string records;
#pragma omp for schedule(dynamic)
    for (std::size_t i = 0; i < blocks_.size(); ++i)
      failure.guard([&] {
        const laz::Chunk& chunk = blocks_[i];
        if (layout_)
          load(chunk, records, layered && worth ? laz::field::z : wanted);
        const char* at = layout_ ? records.data() : source_.bytes.data() + chunk.at;
        const RecordBlock block{at, stride_, chunk.first, chunk.count};
        if (!worth || worth(block)) {
          if (layered && worth && wanted != laz::field::z)
            load(chunk, records, wanted);
          use(i, block);
        }
        source_.advance(chunk.count);
      });
  }
  failure.rethrow();
}

} // namespace linelet::io
