// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "staged_hdf5.h"

namespace linelet::io::hdf5 {

StagedHdf5::StagedHdf5(const std::string& path) : staged_(path)
{
  if (staged_.direct())
    throw FileError(path + ": HDF5 is written to files only, not to devices or pipes");
  file_ = createFile(staged_.place());
}

void
StagedHdf5::publish()
{
  check(H5Fflush(file_.id(), H5F_SCOPE_GLOBAL), "write it");
  if (!file_.reset())
    throw Error("cannot write it");
  staged_.publish();
}

} // namespace linelet::io::hdf5
