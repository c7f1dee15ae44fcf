// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "io/source.h"

namespace linelet::io {

/** \throws FileError, Canceled */
Cloud
readPcd(const Source& source);

} // namespace linelet::io
