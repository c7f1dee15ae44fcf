// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string_view>

#include <linelet/io/cloud.h>
#include <linelet/io/file_options.h>

namespace linelet::io {

/** \brief Whether \a options request the column \a name. */
bool
isWanted(const ReadOptions& options, std::string_view name);

/** \brief Drops the columns of \a cloud that \a options do not request. */
void
keepWanted(Cloud& cloud, const ReadOptions& options);

} // namespace linelet::io
