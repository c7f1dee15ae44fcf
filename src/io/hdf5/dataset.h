// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "chunk_check.h"
#include "handle.h"

namespace linelet::io::hdf5 {

/** \brief A member of a compound value. */
struct Member {
  std::string name;
  ValueType type;
};

/** \brief The type of a packed compound value. */
Handle
compoundType(const std::vector<Member>& members, bool in_file);

/** \brief A dataset that grows: rows of values, in compressed chunks. */
class Column1D {
public:
  /** \brief A new dataset \a name in \a group.
   * \param[in] types of its values in the file and in memory; copied */
  Column1D(const Handle& group,
           const std::string& name,
           hid_t file_type,
           hid_t memory_type);

  /** \brief Adds \a count values, as in memory. */
  void
  append(const void* values, std::size_t count);

  const Handle&
  handle() const
  {
    return dataset_;
  }

private:
  std::string name_;
  Handle memory_type_, dataset_;
  hsize_t size_ = 0;
};

/** \brief Writes \a values as dataset \a name. */
template <class T>
Column1D
writeValues(const Handle& group,
            const std::string& name,
            ValueType type,
            const std::vector<T>& values)
{
  Column1D column(group, name, fileType(type), memoryType(type));
  column.append(values.data(), values.size());
  return column;
}

/** \brief A dataset to read, a value per row. */
class StoredColumn {
public:
  StoredColumn(const Handle& group, const std::string& name);

  /** \brief Number of rows; 0 if it has no rows of values, or more than the file can
   * hold: a damaged count must not allocate memory. */
  std::size_t
  rows() const
  {
    return rows_;
  }

  /** \brief Values per row of a two-dimensional dataset. */
  std::size_t
  width() const
  {
    return width_;
  }

  /** \brief Its members, or one without a name if it is not a compound; none if they
   * are not numbers. */
  const std::vector<Member>&
  members() const
  {
    return members_;
  }

  const Handle&
  handle() const
  {
    return dataset_;
  }

  /** \brief Rows \a first to \a first + \a count of one member, as in memory.
   * \param[out] values room for count * width values of the member's type */
  void
  read(const Member& member, std::size_t first, std::size_t count, void* values) const;

  /** \brief The same of whole rows, as \a type in memory. */
  void
  readRows(const Handle& type, std::size_t first, std::size_t count, void* values) const
  {
    read(type.id(), first, count, values);
  }

  /** \brief All rows as values of \a T. \throws Error unless they are numbers */
  template <class T>
  std::vector<T>
  all(hid_t memory_type) const
  {
    if (members_.size() != 1)
      throw Error("cannot read " + name_ + ": it holds no numbers");
    std::vector<T> values(rows_ * width_);
    read(memory_type, 0, rows_, values.data());
    return values;
  }

private:
  void
  read(hid_t memory_type, std::size_t first, std::size_t count, void* values) const;

  std::string name_;
  Handle dataset_;
  std::size_t rows_ = 0, width_ = 1;
  std::vector<Member> members_;
  mutable ChunkCheck chunks_;
};

} // namespace linelet::io::hdf5
