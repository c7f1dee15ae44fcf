// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/file_work.h"
#include "io/laz/layout.h"
#include "las_encode.h"
#include "las_layout.h"

namespace linelet::io {

/** \brief What a header states about all points together. */
struct LasTotals {
  std::uint64_t points = 0;
  std::array<std::uint64_t, 15> returns{};
  std::array<std::int32_t, 3> low{}, high{}; ///< steps of the grid

  /** \brief Adds a point. */
  void
  add(const std::array<std::int32_t, 3>& at, double return_number);

  /** \brief Adds the totals of other points. */
  void
  add(const LasTotals& more);
};

/** \brief A LAS file for a cloud, or for a part of one: everything except the output of
 * points. */
class LasFront {
public:
  /** \throws FileError if no record can hold the attributes */
  LasFront(const FileWork& target, const Cloud& cloud, bool compress);

  /** \brief Adds the points of the cloud to \a totals. */
  void
  count(LasTotals& totals) const;

  /** \brief Everything before the points: header, records and gap. The points have \a
   * totals and take \a bytes in the file. \throws FileError */
  std::string
  before(const LasTotals& totals, std::uint64_t bytes);

  /** \brief Everything after the points. */
  std::string
  behind() const;

  /** \brief The records of \a number points from \a first on. */
  std::string
  makeRecords(std::size_t first, std::size_t number) const;

  std::size_t
  recordLength() const
  {
    return layout_.record_length;
  }

  /** \brief How the points are compressed; empty: not at all. */
  const std::optional<laz::Layout>&
  compression() const
  {
    return compression_;
  }

  /** \brief Whether records of both fit into one file. */
  bool
  agreesWith(const LasFront& other) const;

private:
  bool
  sameReference() const;
  bool
  keeps(const LasRecord& record) const;
  void
  chooseRecords();
  void
  describeExtras();
  void
  startHeader();
  void
  placeParts(std::uint64_t bytes);
  void
  placeWaveform(std::uint64_t end);
  void
  putTotals(const LasTotals& totals);
  template <class T>
  void
  put(std::size_t at, T value);

  const FileWork& target_;
  const Cloud& cloud_;
  LasSteps steps_;
  LasLayout layout_;
  std::vector<LasRecord> records_, extended_;
  std::string gap_, header_;
  std::optional<laz::Layout> compression_;
};

} // namespace linelet::io
