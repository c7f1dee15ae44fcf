// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <hdf5.h>

#include "io/values.h"

namespace linelet::io::hdf5 {

/** \brief A failure of HDF5; becomes a FileError that names the file. */
class Error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** \brief An identifier of the HDF5 library, closed on destruction. */
class Handle {
public:
  using Close = herr_t (*)(hid_t);

  Handle() = default;

  /** \throws Error "cannot WHAT" if \a id is invalid */
  Handle(hid_t id, Close close, const std::string& what) : id_(id), close_(close)
  {
    if (id < 0)
      throw Error("cannot " + what);
  }
  ~Handle() { reset(); }
  Handle(Handle&& other) noexcept
      : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_)
  {
  }
  Handle&
  operator=(Handle&& other) noexcept
  {
    reset();
    id_ = std::exchange(other.id_, H5I_INVALID_HID);
    close_ = other.close_;
    return *this;
  }

  hid_t
  id() const
  {
    return id_;
  }

  /** \brief Closes it. \return whether that succeeded */
  bool
  reset()
  {
    return id_ < 0 || close_(std::exchange(id_, H5I_INVALID_HID)) >= 0;
  }

private:
  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

/** \throws Error "cannot WHAT" if \a status is a failure */
inline void
check(herr_t status, const std::string& what)
{
  if (status < 0)
    throw Error("cannot " + what);
}

/** \brief Locks the library, which is not thread-safe as built by Debian, for one
 * thread, and silences its messages on stderr. */
class Session {
public:
  Session();
  ~Session();
  Session(const Session&) = delete;
  Session&
  operator=(const Session&) = delete;
};

/** \brief The file \a path, for reading. */
Handle
openFile(const std::string& path);

/** \brief A file in memory, for reading; the bytes are copied. */
Handle
openImage(const void* bytes, std::size_t size);

/** \brief A new file. */
Handle
createFile(const std::string& path);

Handle
openGroup(const Handle& parent, const std::string& name);

/** \brief A new group, with the groups on its path. */
Handle
createGroup(const Handle& parent, const std::string& name);

bool
exists(const Handle& parent, const std::string& name);

/** \brief Names of what \a group holds, in alphabetical order. */
std::vector<std::string>
namesIn(const Handle& group);

/** \brief The type of values, little-endian in a file and as it is in memory. */
hid_t
fileType(ValueType type);
hid_t
memoryType(ValueType type);

/** \brief The type of value stored as \a stored, in either byte order; none if it is
 * not a plain number. linelet writes no types of other sizes, offsets or precisions,
 * and damaged ones make HDF5 1.10 leave its buffers. */
std::optional<ValueType>
valueType(hid_t stored);

// Attributes: small values attached to a group or a dataset.

void
setAttribute(const Handle& object, const char* name, const std::string& text);
void
setAttribute(const Handle& object, const char* name, const std::vector<double>& values);
void
setAttribute(const Handle& object,
             const char* name,
             const std::vector<std::int64_t>& values);

/** \brief \a otherwise if there is no such text. */
std::string
textAttribute(const Handle& object,
              const char* name,
              const std::string& otherwise = {});

/** \brief Exactly \a count numbers, finite or not. \throws Error */
std::vector<double>
numbersAttribute(const Handle& object, const char* name, std::size_t count);

std::vector<std::int64_t>
integersAttribute(const Handle& object, const char* name, std::size_t count);

/** \brief \a otherwise if there is no such number. */
std::int64_t
integerAttribute(const Handle& object, const char* name, std::int64_t otherwise);

} // namespace linelet::io::hdf5
