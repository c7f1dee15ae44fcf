// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/cloud_sink.h>

#include <algorithm>
#include <limits>

#include <linelet/io/output_file.h>

#include "io/files.h"
#include "io/laz/chunk_table.h"
#include "io/source.h"
#include "las/las_front.h"
#include "las/las_records.h"
#include "las/laz_points.h"

namespace linelet::io {

struct CloudSink::State {
  FileWork target;
  bool compress;
  std::unique_ptr<OutputFile> file;
  Cloud head; ///< without points, for what surrounds them in the file
  std::unique_ptr<LasFront> front;
  LasTotals totals;
  std::string buffer;                     ///< records that do not fill a chunk yet
  std::vector<std::uint32_t> chunks;      ///< bytes of each
  std::uint64_t points_at = 0, bytes = 0; ///< of the points in the file

  void
  begin(const Cloud& cloud);
  void
  put(const std::string& records);
  void
  putChunks(std::size_t points);
};

bool
CloudSink::takes(const std::string& path)
{
  const std::string ending = endingOf(path);
  return ending == ".las" || ending == ".laz";
}

CloudSink::CloudSink(const std::string& path,
                     std::vector<std::string>* warnings,
                     ProgressMonitor* monitor,
                     unsigned threads)
    : state_(std::make_unique<State>())
{
  if (!takes(path))
    throw FileError(path + ": only .las and .laz are written part by part; name one "
                           "of these");
  state_->target = {path, warnings, monitor, threads};
  state_->compress = endingOf(path) == ".laz";
}

CloudSink::~CloudSink() = default;

void
CloudSink::State::begin(const Cloud& cloud)
{
  head = cloud; // its columns determine the layout, its points the grid
  front = std::make_unique<LasFront>(target, head, compress);
  file = std::make_unique<OutputFile>(target.name);
  const std::string before = front->before(totals, 0);
  points_at = before.size();
  file->write(before);
  if (!compress)
    return;
  file->write(std::string(8, '\0')); // place of the chunk table
  bytes = 8;
}

void
CloudSink::State::put(const std::string& records)
{
  file->write(records);
  bytes += records.size();
}

/** Compresses the first \a points of the buffer. */
void
CloudSink::State::putChunks(std::size_t points)
{
  const std::size_t length = front->recordLength();
  const auto encoded = encodeChunks(
      *front->compression(),
      points,
      [&](std::size_t first, std::size_t number) {
        return buffer.substr(first * length, number * length);
      },
      target.threads);
  for (const auto& chunk : encoded) {
    put({chunk.begin(), chunk.end()});
    chunks.push_back(static_cast<std::uint32_t>(chunk.size()));
  }
  buffer.erase(0, points * length);
}

void
CloudSink::add(const Cloud& cloud)
{
  State& s = *state_;
  const bool first = s.front == nullptr;
  if (first)
    s.begin(cloud);
  const FileWork quiet{s.target.name, nullptr, s.target.monitor, s.target.threads};
  const LasFront part(quiet, cloud, s.compress);
  if (!part.agreesWith(*s.front))
    throw PartsDiffer(
        s.target.name +
        ": some points need other records than the first ones; process it "
        "in one piece");
  part.count(s.totals);
  forEachRecords(part, cloud.points.size(), s.target, [&](const std::string& records) {
    if (s.compress)
      s.buffer += records;
    else
      s.put(records);
  });
  if (!s.compress)
    return;
  const std::size_t chunk = s.front->compression()->chunk_size;
  if (const std::size_t whole = s.buffer.size() / s.front->recordLength() / chunk;
      whole > 0)
    s.putChunks(whole * chunk);
}

void
CloudSink::commit()
{
  State& s = *state_;
  if (s.front == nullptr)
    throw FileError(s.target.name + ": there are no points to write");
  if (s.compress) {
    s.putChunks(s.buffer.size() / s.front->recordLength());
    std::string place(8, '\0');
    store<std::uint64_t>(place.data(), s.points_at + s.bytes);
    s.file->rewrite(s.points_at, place);
    const auto table = laz::writeChunkTable(s.chunks);
    s.put({table.begin(), table.end()});
  }
  s.file->write(s.front->behind());
  s.file->rewrite(0, s.front->before(s.totals, s.bytes));
  s.file->commit();
}

} // namespace linelet::io
