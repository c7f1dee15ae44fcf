// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "reference_systems.h"

namespace linelet::io {

namespace {

const ReferenceSystems* known = nullptr; // set before main

} // namespace

const ReferenceSystems*
referenceSystems()
{
  return known;
}

void
setReferenceSystems(const ReferenceSystems* systems)
{
  known = systems;
}

} // namespace linelet::io
