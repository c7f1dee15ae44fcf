// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "raw_extras.h"

#include <algorithm>
#include <string>

#include "io/las/las_format.h"
#include "las_store.h"

namespace linelet::io {

namespace {

/** \brief Fills in for bytes that the columns hold. */
void
appendZeros(hdf5::Column1D& data, std::size_t count)
{
  constexpr std::size_t block = 1 << 20;
  const std::string zeros(std::min(count, block), '\0');
  for (std::size_t left = count; left > 0; left -= std::min(left, block))
    data.append(zeros.data(), std::min(left, block));
}

} // namespace

RawExtras::RawExtras(const LasOrigin& like)
{
  for (const LasExtra& extra : like.extras)
    entries_.push_back({extra.bytes, {}});
}

void
RawExtras::append(const hdf5::Handle& group,
                  const Cloud& cloud,
                  std::size_t first,
                  std::size_t count,
                  std::size_t written)
{
  for (std::size_t e = 0; e < entries_.size(); ++e) {
    const bool has =
        cloud.las != nullptr && e < cloud.las->extras.size() &&
        cloud.las->extras[e].bytes == entries_[e].bytes &&
        cloud.las->extras[e].raw.size() == entries_[e].bytes * cloud.points.size();
    if (!has && !entries_[e].data)
      continue;
    const std::size_t length = entries_[e].bytes;
    if (!entries_[e].data) {
      entries_[e].data.emplace(group, hdf5::rawName(e), H5T_STD_U8LE, H5T_NATIVE_UINT8);
      appendZeros(*entries_[e].data, written * length);
    }
    if (has)
      entries_[e].data->append(cloud.las->extras[e].raw.data() + first * length,
                               count * length);
    else
      appendZeros(*entries_[e].data, count * length);
  }
}

} // namespace linelet::io
