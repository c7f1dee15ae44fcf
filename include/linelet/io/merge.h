// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/io/cloud.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

/** \brief Appends the points of \a more to \a cloud, relative to its shift, with the
 * attributes that both have.
 * \param[out] warnings one sentence for the attributes that only one of them has */
void
append(Cloud& cloud, const Cloud& more, std::vector<std::string>* warnings = nullptr);

} // namespace io
} // namespace linelet
