// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <linelet/io/file_error.h>
#include <linelet/io/output_file.h>
#include <linelet/support/points.h>

namespace linelet::apps {

/** \brief Collects values as bytes, in the order of \ref Loader; to be read on a
 * machine of the same kind. */
class Saver {
public:
  template <class... Ts>
  void
  all(const Ts&... values)
  {
    (add(values), ...);
  }

  template <class T, class Each>
  void
  list(std::vector<T>& values, Each each)
  {
    add(static_cast<std::uint64_t>(values.size()));
    for (T& value : values)
      each(value);
  }

  /** \throws io::FileError */
  void
  save(const std::string& path) const
  {
    io::OutputFile file(path);
    file.write(bytes_);
    file.commit();
  }

private:
  template <class T>
  void
  add(const T& value)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }
  void
  add(const Point& p)
  {
    all(p.x(), p.y(), p.z());
  }
  void
  add(const std::string& text)
  {
    add(static_cast<std::uint64_t>(text.size()));
    bytes_ += text;
  }

  std::string bytes_;
};

/** \brief Reads what a \ref Saver saved. All functions throw io::FileError if it is
 * missing or damaged. */
class Loader {
public:
  explicit Loader(std::string path) : path_(std::move(path))
  {
    std::ifstream file(path_, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(file), {});
  }

  template <class... Ts>
  void
  all(Ts&... values)
  {
    (take(values), ...);
  }

  template <class T, class Each>
  void
  list(std::vector<T>& values, Each each)
  {
    const std::size_t count = size();
    values.clear();
    for (std::size_t k = 0; k < count; ++k) {
      values.emplace_back();
      each(values.back());
    }
  }

private:
  std::size_t
  size()
  {
    std::uint64_t count = 0;
    take(count);
    if (count > bytes_.size() - at_) // each takes at least one byte
      fail();
    return static_cast<std::size_t>(count);
  }

  [[noreturn]] void
  fail() const
  {
    throw io::FileError(path_ + ": is missing or damaged; plan and run it again");
  }

  template <class T>
  void
  take(T& value)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    if (bytes_.size() - at_ < sizeof(T))
      fail();
    std::memcpy(&value, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
  }
  void
  take(Point& p)
  {
    all(p.x(), p.y(), p.z());
  }
  void
  take(std::string& text)
  {
    const std::size_t length = size();
    text = bytes_.substr(at_, length);
    at_ += length;
  }

  std::string path_, bytes_;
  std::size_t at_ = 0;
};

} // namespace linelet::apps
