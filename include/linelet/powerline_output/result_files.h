// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC powerline {

/** \brief The files of \a folder that \ref writePowerLineFiles writes, in its order. */
std::vector<std::string>
powerLineFiles(const std::string& folder, bool compress = false);

} // namespace powerline
} // namespace linelet
