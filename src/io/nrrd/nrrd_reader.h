// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "io/source.h"

namespace linelet::io {

/** \brief The samples of a volume as points, tensors as the attributes xx, xy, xz, yy,
 * yz, zz (teem's NRRD with attached header, encoded raw, as text, or by gzip).
 *
 * Tensors have an axis of their own: 3D-symmetric-matrix, 3D-masked-symmetric-matrix
 * (samples with a mask below 0.5 are left out, as in teem) or 3D-matrix, whose
 * symmetric part is used. They are rotated from the measurement frame into the space of
 * the points. A volume of numbers gives the attribute `value`. */
Cloud
readNrrd(const Source& source);

} // namespace linelet::io
