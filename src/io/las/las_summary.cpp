// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/las_summary.h>

#include "io/reference_systems.h"
#include "io/source.h"

#include "las_format.h"

namespace linelet::io {

std::optional<LasSummary>
lasSummary(const Cloud& cloud)
{
  if (cloud.las == nullptr)
    return {};
  const LasOrigin& las = *cloud.las;
  LasSummary summary;
  summary.scale = las.grid.scale;
  summary.offset = las.grid.offset;
  summary.copc_levels = las.copc_levels;
  if (const ReferenceSystems* systems = referenceSystems(); systems != nullptr)
    summary.epsg = systems->epsgOf(cloud.wkt);
  for (const auto* records : {&las.records, &las.extended})
    for (const LasRecord& record : *records)
      summary.records.push_back(cleanName(record.user()) + " " +
                                std::to_string(record.number()) + ", " +
                                std::to_string(record.data.size()) + " bytes");
  return summary;
}

} // namespace linelet::io
