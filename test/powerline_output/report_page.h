// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <linelet/powerline_output/output_files.h>

#include "powerline/network_by_hand.h"

namespace linelet::test {

/** What is wrong with the nesting of tags, scripts aside; empty if nothing is. */
inline std::string
nestingError(std::string page)
{
  for (std::size_t at; (at = page.find("<script>")) != std::string::npos;)
    page.erase(at, page.find("</script>", at) + 9 - at);
  std::vector<std::string> open;
  const std::regex tag("<(/?)([A-Za-z][A-Za-z0-9]*)([^<>]*?)(/?)>");
  std::size_t brackets = 0;
  for (std::sregex_iterator it(page.begin(), page.end(), tag), end; it != end; ++it) {
    ++brackets;
    const std::string name = (*it)[2];
    if ((*it)[1] == "/") {
      if (open.empty() || open.back() != name)
        return "</" + name + "> closes " + (open.empty() ? "nothing" : open.back());
      open.pop_back();
    }
    else if ((*it)[4] != "/")
      open.push_back(name);
  }
  if (!open.empty())
    return open.back() + " is not closed";
  // Every bracket belongs to a tag or to the document type.
  const auto count =
      static_cast<std::size_t>(std::count(page.begin(), page.end(), '<'));
  return count == brackets + 1 ? "" : "a stray <";
}

inline std::size_t
occurrences(const std::string& text, const std::string& what)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + 1))
    ++count;
  return count;
}

/** The report of a network made by hand. */
class Report : public testing::Test {
protected:
  Report() : network_(networkByHand()), cloud_(cloudByHand(network_))
  {
    options_.source = "by_hand.las";
  }

  std::string
  page() const
  {
    return powerLineReport(cloud_, network_, options_);
  }

  powerline::PowerLineNetwork network_;
  io::Cloud cloud_;
  powerline::OutputOptions options_;
};

} // namespace linelet::test
