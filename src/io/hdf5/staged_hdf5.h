// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/io/file_error.h>

#include "handle.h"
#include "io/staged_file.h"

namespace linelet::io::hdf5 {

/** \brief An HDF5 file being written, which appears complete or not at all. */
class StagedHdf5 {
public:
  /** \throws FileError, Error */
  explicit StagedHdf5(const std::string& path);

  const Handle&
  file() const
  {
    return file_;
  }

  /** \brief The file is complete: moves it into place. No other handle into it may be
   * open.
   *
   * \throws FileError, Error */
  void
  publish();

private:
  StagedFile staged_;
  Handle file_;
};

/** \brief Calls \a work; errors of HDF5 name the file \a path. */
template <class Work>
void
writing(const std::string& path, Work&& work)
{
  const Session session;
  try {
    work();
  }
  catch (const Error& error) {
    throw FileError(path + ": " + error.what() +
                    "; check that the folder exists, is writable and has free space");
  }
}

} // namespace linelet::io::hdf5
