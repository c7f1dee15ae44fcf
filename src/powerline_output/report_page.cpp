// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "report_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace linelet::powerline::report {

std::string
number(double value, int decimals)
{
  if (!std::isfinite(value))
    return "–";
  std::array<char, 64> buffer;
  std::snprintf(buffer.data(), buffer.size(), "%.*f", decimals, value);
  const std::string text = buffer.data();
  // No minus sign before zero.
  return text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos
             ? text.substr(1)
             : text;
}

std::string
escaped(std::string_view text)
{
  std::string out;
  for (const char c : text)
    switch (c) {
    case '&':
      out += "&amp;";
      break;
    case '<':
      out += "&lt;";
      break;
    case '>':
      out += "&gt;";
      break;
    case '"':
      out += "&quot;";
      break;
    default:
      out += c;
    }
  return out;
}

double
roundStep(double range, int count)
{
  const double raw = range / count;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  const double lead = raw / power;
  return power * (lead <= 1.5 ? 1 : lead <= 3.5 ? 2 : lead <= 7.5 ? 5 : 10);
}

std::string_view
wireColor(int number)
{
  // Distinguishable with any color vision; red is reserved for hazards.
  static constexpr std::array<std::string_view, 8> colors = {"#0072b2",
                                                             "#e69f00",
                                                             "#009e73",
                                                             "#8e5ea2",
                                                             "#56b4e9",
                                                             "#8c6d31",
                                                             "#3b3b3b",
                                                             "#cc79a7"};
  return colors[static_cast<std::size_t>(number > 0 ? number - 1 : 0) % colors.size()];
}

std::string
Content::length(double meters, int decimals) const
{
  const std::string text = number(meters, decimals);
  const double foot = metric.units().plan;
  // International and US survey feet differ by 2e-6.
  return std::abs(foot - 0.3048) < 1e-5 && std::isfinite(meters)
             ? text + " (" + number(meters / foot, std::max(0, decimals - 1)) + " ft)"
             : text;
}

std::string
Content::supportName(int id) const
{
  return id > 0 ? "P" + std::to_string(id) : "edge";
}

} // namespace linelet::powerline::report
