// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vector_points.h"

namespace linelet::io {

namespace {

const VectorPoints* known_reader = nullptr; // set before main

} // namespace

const VectorPoints*
vectorPoints()
{
  return known_reader;
}

void
setVectorPoints(const VectorPoints* reader)
{
  known_reader = reader;
}

} // namespace linelet::io
