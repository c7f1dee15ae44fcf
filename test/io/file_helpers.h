// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <unistd.h>

#include <gtest/gtest.h>

namespace linelet::test {

inline std::string
bytesOf(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline void
writeBytes(const std::filesystem::path& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
}

/** \brief Number of type T at byte \a at, as a little-endian machine stores it. */
template <class T>
T
numberAt(const std::string& bytes, std::size_t at)
{
  T value{};
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

/** \brief A folder that lasts as long as a test. */
class Folder {
public:
  Folder()
  {
    std::string name =
        (std::filesystem::temp_directory_path() / "linelet-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder&
  operator=(const Folder&) = delete;

  std::string
  file(const std::string& name) const
  {
    return (path_ / name).string();
  }

  const std::filesystem::path&
  path() const
  {
    return path_;
  }

private:
  std::filesystem::path path_;
};

} // namespace linelet::test
