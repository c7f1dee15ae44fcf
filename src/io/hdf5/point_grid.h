// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <linelet/io/cloud.h>

#include "dataset.h"
#include "io/source.h"
#include "raw_extras.h"

namespace linelet::io {

/** \brief The points of a cloud in a file: places, attributes, and the boxes of the
 * fragments they come in. */
class PointGrid {
public:
  /** \param[in] like the attributes, reference system and LAS header that all blocks
   * share */
  PointGrid(const hdf5::Handle& file, const Cloud& like);

  /** \brief Whether \a cloud has the same attributes as the others. */
  bool
  fits(const Cloud& cloud) const;

  /** \brief Adds \a count points of \a cloud, which fits, from \a first on. */
  void
  append(const Cloud& cloud, std::size_t first, std::size_t count);

private:
  /** \brief A dataset, and which columns of a cloud its members are. */
  struct Field {
    std::vector<std::size_t> columns; ///< one, or the entries of a tensor
    ValueType type;
    hdf5::Column1D data;
  };

  /** \return number of columns that it holds */
  std::size_t
  beginField(const Cloud& like, std::size_t first, UniqueNames& names);
  static void
  appendField(Field& field, const Cloud& cloud, std::size_t first, std::size_t count);
  void
  appendFragment(std::size_t count, const std::array<double, 6>& box);

  Point shift_;
  std::vector<Column> form_; ///< names and types
  std::uint64_t written_ = 0;
  hdf5::Handle las_, group_;
  std::optional<hdf5::Column1D> fragments_, places_;
  std::optional<RawExtras> raw_;
  std::vector<Field> fields_;
};

} // namespace linelet::io
