// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

#include <linelet/io/cloud.h>

#include "io/source.h"
#include "las_blocks.h"
#include "las_header.h"
#include "las_layout.h"

namespace linelet::io {

/** \brief Reads everything in records except the coordinates, the fields of their
 * format and their extra bytes, into columns of a cloud. */
class LasColumns {
public:
  /** \brief Creates a column in \a cloud for every wanted attribute, and records its
   * name in \a origin. */
  LasColumns(const Source& source,
             const LasHeader& header,
             LasOrigin& origin,
             Cloud& cloud);

  /** \brief The layers of a compressed record that the columns need. */
  laz::Fields
  layers() const
  {
    return layers_;
  }

  /** \brief Makes room for as many points as the header now counts. */
  void
  makeRoom();

  /** \brief Reads a block; threads may read different blocks concurrently. */
  void
  read(const RecordBlock& block);

  /** \brief Drops the raw extra bytes that the columns represent. */
  void
  finish();

private:
  void
  findExtras();

  /** Whether the column \a name is read. In compatibility mode, attributes are composed
   * from columns of other names. */
  bool
  reads(std::string_view name) const;

  void
  makeColumns();

  /** Finds the extra bytes to keep raw, if they are read as a whole, since the columns
   * may not represent all of them. */
  void
  findRaw();

  void
  readExtras(const RecordBlock& block);

  static constexpr std::size_t unread = static_cast<std::size_t>(-1);

  const Source& source_;
  const LasHeader& header_;
  LasOrigin& origin_;
  Cloud& cloud_;
  std::vector<LasField> fields_;           ///< of the first columns
  laz::Fields layers_ = 0;                 ///< of all columns
  std::vector<std::size_t> extra_columns_; ///< of the components of the extra entries
  std::vector<char> keeps_raw_;            ///< for every extra entry
  std::vector<std::unique_ptr<std::atomic<bool>>> inexact_; ///< one per extra entry
};

} // namespace linelet::io
