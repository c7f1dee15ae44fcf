// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "las_layers.h"

#include <string_view>
#include <utility>

namespace linelet::io {

laz::Fields
layersOf(const LasField& field)
{
  using namespace laz::field;
  constexpr std::pair<std::string_view, laz::Fields> layers[] = {
      {"return_number", 0},
      {"number_of_returns", 0},
      {"scanner_channel", 0},
      {"classification", classification},
      {"intensity", intensity},
      {"scan_angle", scan_angle},
      {"user_data", user_data},
      {"point_source_id", point_source},
      {"gps_time", gps_time},
      {"red", color},
      {"green", color},
      {"blue", color},
      {"nir", nir}};
  for (const auto& [name, layer] : layers)
    if (field.name == name)
      return layer;
  return field.bits != 0 ? laz::field::flags : wave_packet;
}

} // namespace linelet::io
