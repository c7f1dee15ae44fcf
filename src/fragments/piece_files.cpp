// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "piece_files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include <unistd.h>

#include <linelet/io/file_error.h>

namespace linelet::fragments {

namespace fs = std::filesystem;

namespace {

struct Closer {
  void
  operator()(std::FILE* file) const
  {
    std::fclose(file);
  }
};
using File = std::unique_ptr<std::FILE, Closer>;

[[noreturn]] void
cannotWrite(const std::string& path)
{
  throw io::FileError(
      path + ": cannot be written (" + std::strerror(errno) +
      "); check that the folder exists, is writable and has free space");
}

} // namespace

PieceFiles::~PieceFiles()
{
  for (const auto& piece : pieces_)
    if (!piece.second.place.empty())
      std::remove(piece.second.place.c_str());
}

void
PieceFiles::flush()
{
  for (auto& [fragment, piece] : pieces_) {
    if (piece.records.empty())
      continue;
    if (piece.place.empty()) {
      const std::string name = path_(fragment);
      std::error_code ignored; // writing the file reports it
      fs::create_directories(fs::path(name).parent_path(), ignored);
      piece.place = name + ".part-" + std::to_string(::getpid());
      std::remove(piece.place.c_str());
    }
    const File file(std::fopen(piece.place.c_str(), "ab"));
    const std::size_t count = piece.records.size();
    if (!file ||
        std::fwrite(piece.records.data(), sizeof(PieceRecord), count, file.get()) !=
            count ||
        std::fflush(file.get()) != 0)
      cannotWrite(piece.place);
    piece.points += count;
    piece.records.clear();
  }
}

std::map<std::size_t, std::uint64_t>
PieceFiles::publish()
{
  std::map<std::size_t, std::uint64_t> points;
  for (auto& [fragment, piece] : pieces_) {
    const std::string name = path_(fragment);
    if (std::rename(piece.place.c_str(), name.c_str()) != 0)
      cannotWrite(name);
    piece.place.clear();
    points[fragment] = piece.points;
  }
  return points;
}

void
readPiece(const std::string& path, const std::function<void(const PieceRecord&)>& use)
{
  const File file(std::fopen(path.c_str(), "rb"));
  std::vector<PieceRecord> block(65536);
  std::size_t got = 0;
  while (file && (got = std::fread(
                      block.data(), sizeof(PieceRecord), block.size(), file.get())) > 0)
    for (std::size_t i = 0; i < got; ++i)
      use(block[i]);
}

} // namespace linelet::fragments
