// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <stdexcept>

namespace linelet::laz {

/** \brief Invalid compressed data. what() is a clause to follow the name of the
 * file. */
class Error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

} // namespace linelet::laz
