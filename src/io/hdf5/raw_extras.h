// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <linelet/io/cloud.h>

#include "dataset.h"

namespace linelet::io {

/** \brief The extra bytes that columns cannot represent, written from the first block
 * that has any. */
class RawExtras {
public:
  /** \brief Those of \a like. */
  explicit RawExtras(const LasOrigin& like);

  /** \brief Adds those of \a count points of \a cloud from \a first on to \a group,
   * which already holds \a written points. */
  void
  append(const hdf5::Handle& group,
         const Cloud& cloud,
         std::size_t first,
         std::size_t count,
         std::size_t written);

private:
  struct Entry {
    std::size_t bytes;
    std::optional<hdf5::Column1D> data;
  };
  std::vector<Entry> entries_;
};

} // namespace linelet::io
