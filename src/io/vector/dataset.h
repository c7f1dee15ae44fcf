// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include "complaints.h"

namespace linelet::io {

/** \brief Opens the vector file \a path with the driver of its ending.
 * \throws FileError with GDAL's message */
std::unique_ptr<GDALDataset>
openDataset(const std::string& path, const Complaints& complaints);

/** \brief WKT of the reference system of \a layer; empty if it has none, or a local one
 * that linelet wrote for an unknown system. */
std::string
referenceOf(OGRLayer& layer);

} // namespace linelet::io
