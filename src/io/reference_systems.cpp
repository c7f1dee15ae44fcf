// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "reference_systems.h"

#include <linelet/io/file_error.h>

namespace linelet::io {

namespace {

const ReferenceSystems* known_systems = nullptr; // set before main

} // namespace

const ReferenceSystems*
referenceSystems()
{
  return known_systems;
}

std::string
declaredReference(const std::string& text, const std::string& option)
{
  if (known_systems == nullptr)
    throw FileError(option + " " + text +
                    ": this program was linked without linelet::vector, which knows "
                    "reference systems");
  std::string wkt = known_systems->wktOfText(text);
  if (wkt.empty())
    throw FileError(option + " " + text +
                    " is not a reference system; give EPSG:n or a file of WKT");
  return wkt;
}

void
setReferenceSystems(const ReferenceSystems* systems)
{
  known_systems = systems;
}

} // namespace linelet::io
