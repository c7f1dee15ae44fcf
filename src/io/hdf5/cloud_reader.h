// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "io/source.h"

namespace linelet::io {

/** \brief The points of a fiber bundle in HDF5.
 *
 * \throws FileError, Canceled */
Cloud
readHdf5(const Source& source);

} // namespace linelet::io
