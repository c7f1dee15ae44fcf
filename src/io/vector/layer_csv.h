// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>

#include <linelet/io/vector_file.h>

namespace linelet::io {

/** \brief \a layer as the text of a CSV file (RFC 4180 with LF): a row of names, then a
 * row per feature. */
std::string
layerAsCsv(const VectorLayer& layer);

} // namespace linelet::io
