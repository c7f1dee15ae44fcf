// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <memory>
#include <string>

class OGRSpatialReference;

namespace linelet::io {

struct ReleaseReference {
  void
  operator()(OGRSpatialReference* reference) const;
};
using Reference = std::unique_ptr<OGRSpatialReference, ReleaseReference>;

/** \brief The reference system that \a wkt describes, east before north; null where it
 * is empty or cannot be understood. */
Reference
parseReference(const std::string& wkt);

} // namespace linelet::io
