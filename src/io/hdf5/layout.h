// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "dataset.h"

namespace linelet::io::hdf5 {

// Names of the layout, see hdf5_file.h.

inline constexpr const char* time_slice = "t=0";
inline constexpr const char* chart = "StandardCartesianChart3D";
inline constexpr const char* positions = "Positions";
inline constexpr const char* fragments = "Fragments";
inline constexpr const char* tensor = "tensor";
inline constexpr std::array<std::string_view, 6> tensor_entries = {
    "xx", "xy", "xz", "yy", "yz", "zz"};

inline const std::string points_grid = std::string(time_slice) + "/points";
inline const std::string curves_grid = std::string(time_slice) + "/curves";

/** \brief The vertices of a grid in the common chart. */
inline std::string
chartOf(const std::string& grid)
{
  return grid + "/Points/" + chart;
}

/** \brief The members of a position. */
inline const std::vector<Member>&
positionMembers()
{
  static const std::vector<Member> members = {
      {"x", ValueType::Float64}, {"y", ValueType::Float64}, {"z", ValueType::Float64}};
  return members;
}

/** \brief The members of an entry of Fragments. */
inline const std::vector<Member>&
fragmentMembers()
{
  static const std::vector<Member> members = {{"first", ValueType::UInt64},
                                              {"count", ValueType::UInt64},
                                              {"low_x", ValueType::Float64},
                                              {"low_y", ValueType::Float64},
                                              {"low_z", ValueType::Float64},
                                              {"high_x", ValueType::Float64},
                                              {"high_y", ValueType::Float64},
                                              {"high_z", ValueType::Float64}};
  return members;
}

/** \brief \a name as that of a link, in which slashes and a lone dot are special. */
inline std::string
linkName(const std::string& name)
{
  std::string link = name;
  std::replace(link.begin(), link.end(), '/', '_');
  return link.empty() || link == "." ? "_" : link;
}

/** \brief A dataset of positions to write. */
inline Column1D
positionColumn(const Handle& group)
{
  return {group,
          positions,
          compoundType(positionMembers(), true).id(),
          compoundType(positionMembers(), false).id()};
}

} // namespace linelet::io::hdf5
