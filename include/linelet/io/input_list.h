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
  std::vector<std::string> files; ///< in the order of the names, none twice
  bool several = false;           ///< more than one, or one by a folder or a list
};

/** \brief Finds the point files that \a names name: files, folders (all point files
 * right in them, by name), virtual point clouds (.vpc) and lists (.txt whose lines are
 * paths, relative to the list).
 * \throws FileError where there is none, or a list names what is not there */
InputList
findInputs(const std::vector<std::string>& names);

} // namespace io
} // namespace linelet
