// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/output_file.h>

#include <cerrno>
#include <filesystem>

#include <sys/stat.h>

#include <linelet/io/file_error.h>
#include <linelet/io/output_check.h>

#include "files.h"
#include "staged_file.h"

namespace linelet::io {

void
checkWritable(const std::string& path)
{
  if (!StagedFile(path).direct()) // a pipe must not be opened twice
    OutputFile probe(path);
}

bool
isSameFile(const std::string& one, const std::string& other)
{
  const std::string identity = identityOf(one);
  return !identity.empty() && identity == identityOf(other);
}

std::string
identityOf(const std::string& path)
{
  namespace fs = std::filesystem;
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) {
    const bool is_kept = S_ISREG(status.st_mode) || S_ISDIR(status.st_mode);
    return is_kept ? "file " + std::to_string(status.st_dev) + " " +
                         std::to_string(status.st_ino)
                   : std::string();
  }
  std::error_code error;
  const fs::path place = fs::weakly_canonical(fs::absolute(path, error), error);
  return error ? std::string() : place.string();
}

OutputFile::OutputFile(const std::string& path)
    : path_(path), staged_(std::make_unique<StagedFile>(path))
{
  file_ = std::fopen(staged_->place().c_str(), "wb");
  if (file_ == nullptr)
    throw FileError(cannotWrite(path, errno));
}

OutputFile::~OutputFile()
{
  if (file_ != nullptr)
    std::fclose(file_);
}

void
OutputFile::write(std::string_view bytes)
{
  if (!bytes.empty() &&
      std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size())
    fail();
}

void
OutputFile::rewrite(std::size_t place, std::string_view bytes)
{
  if (std::fseek(file_, static_cast<long>(place), SEEK_SET) != 0)
    fail();
  write(bytes);
  if (std::fseek(file_, 0, SEEK_END) != 0)
    fail();
}

void
OutputFile::commit()
{
  if (std::fflush(file_) != 0)
    fail();
  std::fclose(file_);
  file_ = nullptr;
  staged_->publish();
}

void
OutputFile::fail()
{
  const int error = errno;
  throw FileError(cannotWrite(path_, error));
}

} // namespace linelet::io
