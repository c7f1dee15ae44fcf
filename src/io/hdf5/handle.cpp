// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "handle.h"

#include <iterator>
#include <mutex>

namespace linelet::io::hdf5 {

namespace {

/// Longer texts are neither names nor reference systems.
constexpr std::size_t longest_text = 1 << 20;

std::mutex&
library()
{
  static std::mutex mutex;
  return mutex;
}

Handle
simpleSpace(std::size_t count)
{
  const hsize_t extent = count;
  return {H5Screate_simple(1, &extent, nullptr), H5Sclose, "describe an attribute"};
}

void
setNumbers(const Handle& object,
           const char* name,
           const void* values,
           std::size_t count,
           hid_t memory_type,
           hid_t file_type)
{
  const Handle space = simpleSpace(count);
  const Handle attribute(
      H5Acreate2(object.id(), name, file_type, space.id(), H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose,
      std::string("write attribute ") + name);
  check(H5Awrite(attribute.id(), memory_type, values),
        std::string("write attribute ") + name);
}

/** \brief The numbers of attribute \a name as \a type, \a count of them. */
template <class T>
std::vector<T>
numbers(const Handle& object, const char* name, hid_t type, std::size_t count)
{
  const std::string what = std::string("read attribute ") + name;
  const Handle attribute(H5Aopen(object.id(), name, H5P_DEFAULT), H5Aclose, what);
  const Handle space(H5Aget_space(attribute.id()), H5Sclose, what);
  const Handle stored(H5Aget_type(attribute.id()), H5Tclose, what);
  if (H5Sget_simple_extent_npoints(space.id()) != static_cast<hssize_t>(count) ||
      !valueType(stored.id()))
    throw Error("cannot " + what + ": it is not " + std::to_string(count) + " numbers");
  std::vector<T> values(count);
  check(H5Aread(attribute.id(), type, values.data()), what);
  return values;
}

} // namespace

Session::Session()
{
  library().lock();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Session::~Session()
{
  library().unlock();
}

Handle
openFile(const std::string& path)
{
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "open it");
  // Locks fail on network disks, and are not needed: files are never written in place.
  H5Pset_file_locking(access.id(), false, true);
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id()),
          H5Fclose,
          "open it as HDF5: it is damaged or of another format"};
}

Handle
openImage(const void* bytes, std::size_t size)
{
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "open it");
  check(H5Pset_fapl_core(access.id(), 1 << 20, false), "open it");
  // The library copies the bytes and does not change these.
  check(H5Pset_file_image(access.id(), const_cast<void*>(bytes), size), "open it");
  return {H5Fopen("image", H5F_ACC_RDONLY, access.id()),
          H5Fclose,
          "open it as HDF5: it is damaged or of another format"};
}

Handle
createFile(const std::string& path)
{
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make it");
  H5Pset_file_locking(access.id(), false, true);
  // The format of 1.8, which all current readers support.
  check(H5Pset_libver_bounds(access.id(), H5F_LIBVER_EARLIEST, H5F_LIBVER_V18),
        "make it");
  return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id()),
          H5Fclose,
          "make it"};
}

Handle
openGroup(const Handle& parent, const std::string& name)
{
  return {
      H5Gopen2(parent.id(), name.c_str(), H5P_DEFAULT), H5Gclose, "read group " + name};
}

Handle
createGroup(const Handle& parent, const std::string& name)
{
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose, "make group " + name);
  check(H5Pset_create_intermediate_group(links.id(), 1), "make group " + name);
  return {H5Gcreate2(parent.id(), name.c_str(), links.id(), H5P_DEFAULT, H5P_DEFAULT),
          H5Gclose,
          "make group " + name};
}

bool
exists(const Handle& parent, const std::string& name)
{
  return H5Lexists(parent.id(), name.c_str(), H5P_DEFAULT) > 0 &&
         H5Oexists_by_name(parent.id(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string>
namesIn(const Handle& group)
{
  H5G_info_t info;
  check(H5Gget_info(group.id(), &info), "list a group");
  std::vector<std::string> names;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    const auto nameAt = [&](char* buffer, std::size_t size) {
      return H5Lget_name_by_idx(
          group.id(), ".", H5_INDEX_NAME, H5_ITER_INC, i, buffer, size, H5P_DEFAULT);
    };
    const ssize_t length = nameAt(nullptr, 0);
    if (length < 0 || static_cast<std::size_t>(length) > longest_text)
      throw Error("cannot list a group");
    std::string name(static_cast<std::size_t>(length) + 1, '\0');
    if (nameAt(name.data(), name.size()) < 0)
      throw Error("cannot list a group");
    name.pop_back();
    names.push_back(std::move(name));
  }
  return names;
}

hid_t
fileType(ValueType type)
{
  const hid_t types[] = {H5T_STD_I8LE,
                         H5T_STD_U8LE,
                         H5T_STD_I16LE,
                         H5T_STD_U16LE,
                         H5T_STD_I32LE,
                         H5T_STD_U32LE,
                         H5T_STD_I64LE,
                         H5T_STD_U64LE,
                         H5T_IEEE_F32LE,
                         H5T_IEEE_F64LE};
  return types[static_cast<std::size_t>(type)];
}

hid_t
memoryType(ValueType type)
{
  const hid_t types[] = {H5T_NATIVE_INT8,
                         H5T_NATIVE_UINT8,
                         H5T_NATIVE_INT16,
                         H5T_NATIVE_UINT16,
                         H5T_NATIVE_INT32,
                         H5T_NATIVE_UINT32,
                         H5T_NATIVE_INT64,
                         H5T_NATIVE_UINT64,
                         H5T_NATIVE_FLOAT,
                         H5T_NATIVE_DOUBLE};
  return types[static_cast<std::size_t>(type)];
}

std::optional<ValueType>
valueType(hid_t stored)
{
  const hid_t swapped[] = {H5T_STD_I8BE,
                           H5T_STD_U8BE,
                           H5T_STD_I16BE,
                           H5T_STD_U16BE,
                           H5T_STD_I32BE,
                           H5T_STD_U32BE,
                           H5T_STD_I64BE,
                           H5T_STD_U64BE,
                           H5T_IEEE_F32BE,
                           H5T_IEEE_F64BE};
  for (std::size_t k = 0; k < std::size(swapped); ++k) {
    const auto type = static_cast<ValueType>(k);
    if (H5Tequal(stored, fileType(type)) > 0 || H5Tequal(stored, swapped[k]) > 0)
      return type;
  }
  return std::nullopt;
}

void
setAttribute(const Handle& object, const char* name, const std::string& text)
{
  const std::string what = std::string("write attribute ") + name;
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, what);
  check(H5Tset_size(type.id(), text.size() + 1), what);
  check(H5Tset_cset(type.id(), H5T_CSET_UTF8), what);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, what);
  const Handle attribute(
      H5Acreate2(object.id(), name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose,
      what);
  check(H5Awrite(attribute.id(), type.id(), text.c_str()), what);
}

void
setAttribute(const Handle& object, const char* name, const std::vector<double>& values)
{
  setNumbers(
      object, name, values.data(), values.size(), H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE);
}

void
setAttribute(const Handle& object,
             const char* name,
             const std::vector<std::int64_t>& values)
{
  setNumbers(
      object, name, values.data(), values.size(), H5T_NATIVE_INT64, H5T_STD_I64LE);
}

std::string
textAttribute(const Handle& object, const char* name, const std::string& otherwise)
{
  if (H5Aexists(object.id(), name) <= 0)
    return otherwise;
  const std::string what = std::string("read attribute ") + name;
  const Handle attribute(H5Aopen(object.id(), name, H5P_DEFAULT), H5Aclose, what);
  const Handle type(H5Aget_type(attribute.id()), H5Tclose, what);
  const Handle space(H5Aget_space(attribute.id()), H5Sclose, what);
  if (H5Tget_class(type.id()) != H5T_STRING ||
      H5Sget_simple_extent_npoints(space.id()) != 1)
    return otherwise;
  if (H5Tis_variable_str(type.id()) > 0) { // as h5py writes strings
    char* text = nullptr;
    check(H5Aread(attribute.id(), type.id(), &text), what);
    std::string result = text == nullptr ? "" : text;
    H5free_memory(text);
    return result;
  }
  const std::size_t size = H5Tget_size(type.id());
  if (size > longest_text)
    throw Error("cannot " + what + ": it is too long");
  std::string text(size, '\0');
  check(H5Aread(attribute.id(), type.id(), text.data()), what);
  return text.substr(0, text.find('\0'));
}

std::vector<double>
numbersAttribute(const Handle& object, const char* name, std::size_t count)
{
  return numbers<double>(object, name, H5T_NATIVE_DOUBLE, count);
}

std::vector<std::int64_t>
integersAttribute(const Handle& object, const char* name, std::size_t count)
{
  return numbers<std::int64_t>(object, name, H5T_NATIVE_INT64, count);
}

std::int64_t
integerAttribute(const Handle& object, const char* name, std::int64_t otherwise)
{
  if (H5Aexists(object.id(), name) <= 0)
    return otherwise;
  return numbers<std::int64_t>(object, name, H5T_NATIVE_INT64, 1).front();
}

} // namespace linelet::io::hdf5
