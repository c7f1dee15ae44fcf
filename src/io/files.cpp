// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "files.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <linelet/io/file_error.h>

namespace linelet::io {

namespace fs = std::filesystem;

namespace {

struct Descriptor {
  int number;
  ~Descriptor() { ::close(number); }
};

[[noreturn]] void
cannotRead(const std::string& path)
{
  throw FileError(path + ": cannot be read (" + std::strerror(errno) +
                  "); check the path and its permissions");
}

} // namespace

MappedFile::MappedFile(const std::string& path, const ProgressMonitor* monitor)
{
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
  struct stat status {};
  if (file.number < 0 || ::fstat(file.number, &status) != 0)
    cannotRead(path);
  if (S_ISDIR(status.st_mode)) {
    errno = EISDIR;
    cannotRead(path);
  }
  if (!S_ISREG(status.st_mode)) {
    char buffer[65536];
    ssize_t got = 0;
    while ((got = ::read(file.number, buffer, sizeof buffer)) > 0) {
      owned_.append(buffer, static_cast<std::size_t>(got));
      throwIfCanceled(monitor);
    }
    if (got < 0)
      cannotRead(path);
    bytes_ = owned_;
    return;
  }
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size == 0)
    return;
  void* mapped = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.number, 0);
  if (mapped == MAP_FAILED)
    cannotRead(path);
  mapped_ = mapped;
  ::madvise(mapped_, size, MADV_SEQUENTIAL);
  bytes_ = {static_cast<const char*>(mapped_), size};
}

MappedFile::~MappedFile()
{
  if (mapped_ != nullptr)
    ::munmap(mapped_, bytes_.size());
}

std::string
cannotWrite(const std::string& path, int error)
{
  return path + ": cannot be written (" +
         (error != 0 ? std::strerror(error) : "unknown reason") +
         "); check that the folder exists, is writable and has free space";
}

std::string
endingOf(const std::string& path)
{
  std::string ending = fs::path(path).extension().string();
  std::transform(
      ending.begin(), ending.end(), ending.begin(), [](unsigned char letter) {
        return static_cast<char>(std::tolower(letter));
      });
  return ending;
}

} // namespace linelet::io
