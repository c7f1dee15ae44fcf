// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

namespace linelet::laz {

/** \brief The layers of point formats 6 to 10 that a reader wants besides x, y, returns
 * and scanner channel; the fields of others keep the values of the first point of the
 * chunk. */
using Fields = std::uint32_t;

namespace field {
constexpr Fields z = 1, classification = 2, flags = 4, intensity = 8, scan_angle = 16,
                 user_data = 32, point_source = 64, gps_time = 128, color = 256,
                 nir = 512, wave_packet = 1024, extra_bytes = 2048, all = 4095;
}

} // namespace linelet::laz
