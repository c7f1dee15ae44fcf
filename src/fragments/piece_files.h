// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace linelet::fragments {

/** \brief A point in the file of a piece, which is an array of these; the ledger knows
 * whether a file is complete. Read on the machine, or kind of machine, that wrote it.
 */
struct PieceRecord {
  double x, y, z;
  std::uint32_t place;
  std::uint8_t number_of_class, number_of_returns;
  std::uint16_t unused;
};
static_assert(sizeof(PieceRecord) == 32);

/** \brief The file of a fragment's piece. */
using PiecePath = std::function<std::string(std::size_t fragment)>;

/** \brief Pieces of one input under construction, under names that no other worker
 * uses; removed unless they are published. */
class PieceFiles {
public:
  explicit PieceFiles(PiecePath path) : path_(std::move(path)) {}
  ~PieceFiles();
  PieceFiles(const PieceFiles&) = delete;
  PieceFiles&
  operator=(const PieceFiles&) = delete;

  void
  add(std::size_t fragment, const PieceRecord& record)
  {
    pieces_[fragment].records.push_back(record);
  }

  /** \brief Appends what was added to the files. \throws io::FileError */
  void
  flush();

  /** \brief Gives all files their final names. \return points by fragment
   * \throws io::FileError */
  std::map<std::size_t, std::uint64_t>
  publish();

private:
  struct Piece {
    std::vector<PieceRecord> records;
    std::string place;
    std::uint64_t points = 0;
  };

  PiecePath path_;
  std::map<std::size_t, Piece> pieces_;
};

/** \brief Calls \a use with every record in the file of a piece, as far as it can be
 * read. */
void
readPiece(const std::string& path, const std::function<void(const PieceRecord&)>& use);

} // namespace linelet::fragments
