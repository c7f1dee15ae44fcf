// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "source.h"

namespace linelet::io {

// Readers of one format each. They check every count against the bytes that are there
// before they allocate by it, and throw FileError.

Cloud
readLas(const Source& source);

Cloud
readPcd(const Source& source);

Cloud
readPly(const Source& source);

/** \brief The points of a fibre bundle in HDF5. */
Cloud
readHdf5(const Source& source);

/** \brief Rows of numbers, with or without a line of names. */
Cloud
readText(const Source& source);

/** \brief The `v` lines. */
Cloud
readObjVertices(const Source& source);

} // namespace linelet::io
