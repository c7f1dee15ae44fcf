// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// How fast the points of a LAZ file are decoded and encoded, without any other work:
//
//   benchmark_laz FILE.laz [THREADS [RUNS]]
//
// One line of JSON: milliseconds with all fields, with x, y, z and class, and for
// encoding, in THREADS (1) threads; and the encoded bytes. On one thread the fastest of
// RUNS (5) counts for every chunk, since other work on the machine only makes it
// slower; on several threads, the fastest run does. The rivals are in rival_laz.py.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <numeric>
#include <string>
#include <vector>

#include "io/files.h"
#include "io/las/las_header.h"
#include "io/laz/chunk_reader.h"
#include "io/laz/chunk_table.h"
#include "io/laz/chunk_writer.h"
#include "io/source.h"

namespace {

using namespace linelet;

class Clock {
public:
  double
  milliseconds() const
  {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() -
                                                     start_)
        .count();
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/** Milliseconds that \a work takes on all chunks: on one thread the sum over chunks of
 * the least of \a runs, otherwise the least of all runs. */
template <class Work>
double
least(std::size_t chunks, int threads, int runs, const Work& work)
{
  std::vector<double> each(chunks, 1e300);
  double all = 1e300;
  for (int run = 0; run < runs; ++run) {
    const Clock whole;
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (std::size_t i = 0; i < chunks; ++i) {
      const Clock clock;
      work(i);
      each[i] = std::min(each[i], clock.milliseconds());
    }
    all = std::min(all, whole.milliseconds());
  }
  return threads == 1 ? std::accumulate(each.begin(), each.end(), 0.0) : all;
}

class LazFile {
public:
  explicit LazFile(const std::string& path) : file_(path)
  {
    io::Source source;
    source.name = path;
    source.bytes = file_.bytes();
    io::LasOrigin origin;
    const io::LasHeader header = io::readLasHeader(source, origin);
    if (!origin.compression)
      source.fail("is not compressed");
    layout_ = *origin.compression;
    chunks_ = laz::readChunkTable(source.bytes, header.points_at, header.count, layout_)
                  .chunks;
    records_.resize(header.count * layout_.recordLength());
    encoded_.resize(chunks_.size());
  }

  void
  decode(std::size_t i, laz::Fields wanted)
  {
    const laz::Chunk& chunk = chunks_[i];
    laz::readChunk(layout_,
                   file_.bytes().substr(chunk.at, chunk.bytes),
                   chunk.count,
                   recordsOf(chunk),
                   wanted);
  }

  void
  encode(std::size_t i)
  {
    const laz::Chunk& chunk = chunks_[i];
    encoded_[i] = laz::writeChunk(layout_, recordsOf(chunk), chunk.count);
  }

  std::size_t
  chunks() const
  {
    return chunks_.size();
  }

  std::size_t
  encodedBytes() const
  {
    std::size_t bytes = 0;
    for (const auto& chunk : encoded_)
      bytes += chunk.size();
    return bytes;
  }

private:
  std::uint8_t*
  recordsOf(const laz::Chunk& chunk)
  {
    return records_.data() + chunk.first * layout_.recordLength();
  }

  io::MappedFile file_;
  laz::Layout layout_;
  std::vector<laz::Chunk> chunks_;
  std::vector<std::uint8_t> records_;
  std::vector<std::vector<std::uint8_t>> encoded_;
};

} // namespace

int
main(int argc, char** argv)
{
  if (argc < 2) {
    std::fprintf(stderr, "usage: benchmark_laz FILE.laz [THREADS [RUNS]]\n");
    return 2;
  }
  const int threads = argc > 2 ? std::atoi(argv[2]) : 1;
  const int runs = argc > 3 ? std::atoi(argv[3]) : 5;
  try {
    LazFile file(argv[1]);
    const auto measured = [&](const auto& work) {
      return least(file.chunks(), threads, runs, work);
    };
    const double some = measured([&](std::size_t i) {
      file.decode(i, laz::field::z | laz::field::classification);
    });
    const double all =
        measured([&](std::size_t i) { file.decode(i, laz::field::all); });
    const double encoding = measured([&](std::size_t i) { file.encode(i); });
    std::printf("{\"threads\": %d, \"all\": %.2f, \"some\": %.2f, \"encode\": %.2f, "
                "\"bytes\": %zu}\n",
                threads,
                all,
                some,
                encoding,
                file.encodedBytes());
  }
  catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
