// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vector_points.h"

namespace linelet::io {

namespace {

const VectorPoints* known = nullptr; // set before main

} // namespace

const VectorPoints*
vectorPoints()
{
  return known;
}

void
setVectorPoints(const VectorPoints* reader)
{
  known = reader;
}

} // namespace linelet::io
