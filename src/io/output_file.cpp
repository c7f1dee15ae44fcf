// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/output_file.h>

#include <cerrno>
#include <filesystem>

#include <linelet/io/file_error.h>

#include "files.h"

namespace linelet::io {

void
checkWritable(const std::string& path)
{
  if (stagingPath(path) != path) // a pipe must not be opened twice
    OutputFile probe(path);
}

OutputFile::OutputFile(const std::string& path)
    : path_(path), staged_(stagingPath(path))
{
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    throw FileError(cannotWrite(path, EISDIR));
  file_ = std::fopen(staged_.c_str(), "wb");
  if (file_ == nullptr)
    throw FileError(cannotWrite(path, errno));
}

OutputFile::~OutputFile()
{
  if (file_ == nullptr)
    return;
  std::fclose(file_);
  if (staged_ != path_)
    std::remove(staged_.c_str());
}

void
OutputFile::write(std::string_view bytes)
{
  if (!bytes.empty() &&
      std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size())
    fail();
}

void
OutputFile::commit()
{
  if (std::fflush(file_) != 0)
    fail();
  std::fclose(file_);
  file_ = nullptr;
  publish(staged_, path_);
}

void
OutputFile::fail()
{
  const int error = errno;
  throw FileError(cannotWrite(path_, error));
}

} // namespace linelet::io
