// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "file_work.h"

namespace linelet::io {

/** \brief A point file to write. */
using Target = FileWork;

void
writeLas(const Target& target, const Cloud& cloud);

/** \brief LAS with compressed points. */
void
writeLaz(const Target& target, const Cloud& cloud);

void
writePcd(const Target& target, const Cloud& cloud);

void
writePly(const Target& target, const Cloud& cloud);

void
writeHdf5(const Target& target, const Cloud& cloud);

/** \brief The points as an unstructured grid of VTKHDF 1.0, for ParaView. */
void
writeVtkHdf(const Target& target, const Cloud& cloud);

void
writeText(const Target& target, const Cloud& cloud);

void
writeObjVertices(const Target& target, const Cloud& cloud);

} // namespace linelet::io
