// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <stdexcept>

#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief A file that cannot be read or written. what() is one sentence that names the
 * file, what is wrong and where, and what to do. */
class FileError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

} // namespace io
} // namespace linelet
