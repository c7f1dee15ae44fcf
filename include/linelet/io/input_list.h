// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief The point files that a user named. */
struct InputList {
  std::vector<std::string> files; ///< in the order of the names, without duplicates
  bool several = false; ///< more than one file, or one from a folder or a list
};

/** \brief Finds the point files that \a names stand for: files, folders (all point
 * files directly in them, by name), virtual point clouds (.vpc) and lists (.txt whose
 * lines are paths, relative to the list).
 * \throws FileError if there are none, or if a list names a missing file */
InputList
findInputs(const std::vector<std::string>& names);

} // namespace io
} // namespace linelet
