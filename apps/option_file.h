// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <istream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace linelet::apps {

/** \brief Option files as written by --print-config. CLI11 writes an empty list as "[]"
 * but reads that as a list with too few values. */
class OptionFile : public CLI::ConfigTOML {
public:
  std::vector<CLI::ConfigItem>
  from_config(std::istream& input) const override
  {
    std::vector<CLI::ConfigItem> items = CLI::ConfigTOML::from_config(input);
    const std::vector<std::string> empty = {"[]"};
    items.erase(std::remove_if(items.begin(),
                               items.end(),
                               [&](const auto& item) { return item.inputs == empty; }),
                items.end());
    return items;
  }
};

} // namespace linelet::apps
