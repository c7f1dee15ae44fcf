// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/powerline/clearance_limits.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <linelet/io/file_error.h>
#include <linelet/support/text.h>

namespace linelet::powerline {

namespace {

using Row = ClearanceLimits::Row;

constexpr double foot = 0.3048; // meters

/** Empirical minimum distances in air to earth (Del) and between phases (Dpp) by the
 * highest voltage of the system: EN 50341-1:2012, table 5.5; below 52 kV those of EN
 * 50423-1:2005. */
struct AirDistance {
  double highest_voltage, to_earth, between_phases; // kV, m, m
};
constexpr AirDistance air_distances[] = {{24, 0.22, 0.25},
                                         {36, 0.35, 0.40},
                                         {52, 0.60, 0.70},
                                         {72.5, 0.70, 0.80},
                                         {82.5, 0.75, 0.85},
                                         {100, 0.90, 1.05},
                                         {123, 1.00, 1.15},
                                         {145, 1.20, 1.40},
                                         {170, 1.30, 1.50},
                                         {245, 1.70, 2.00},
                                         {300, 2.10, 2.40},
                                         {420, 2.80, 3.20},
                                         {525, 3.50, 4.00},
                                         {765, 4.90, 5.60}};

ClearanceLimits
europeanLimits(double voltage)
{
  const AirDistance* air = std::begin(air_distances);
  while (air->highest_voltage < voltage) // the last one exceeds every voltage allowed
    ++air;
  const double del = air->to_earth, dpp = air->between_phases;
  ClearanceLimits limits;
  limits.name = "EN 50341-1:2012 for " + textOf(voltage) + " kV, starting values";
  const double ground = std::max(6.0, 5 + del), pitched = std::max(3.0, 2 + del),
               flat = std::max(5.0, 4 + del), other = std::max(2.0, 1 + dpp);
  limits.rows = {Row{ground, ground + 0.5, ground + 1},
                 Row{del, 1.5 + del, 3.5 + del},
                 Row{pitched, flat, flat + 1},
                 Row{dpp, other, other + 1},
                 Row{del, pitched, pitched + 1},
                 Row{0, del, 1.5 + del}};
  return limits;
}

ClearanceLimits
americanLimits(double voltage)
{
  // To earth, at the highest voltage of operation (105 %).
  const double above = std::max(0.0, 1.05 * voltage / std::sqrt(3.0) - 22);
  const double more = 0.4 / 12 * foot * above;
  // California's General Order 95, appendix E, guidelines to rule 35, case 13.
  const double trees = foot * (voltage < 72    ? 4
                               : voltage < 110 ? 6
                               : voltage < 300 ? 10
                                               : 15);
  ClearanceLimits limits;
  limits.name =
      "NESC rules 232 to 234 and GO 95 for " + textOf(voltage) + " kV, starting values";
  const double ground = 18.5 * foot + more, building = 7.5 * foot + more,
               wire = 4 * foot + more;
  limits.rows = {Row{ground, ground + 0.5, ground + 1},
                 Row{trees / 2, trees, trees + 2},
                 Row{building, building + 0.5, building + 1},
                 Row{wire / 2, wire, wire + 1},
                 Row{wire / 2, wire, wire + 1},
                 Row{0, trees / 2, trees}};
  return limits;
}

double
voltageOf(const std::string& name, const std::string& text)
{
  char* end = nullptr;
  const double voltage = std::strtod(text.c_str(), &end);
  if (end == text.c_str() || *end != '\0' || !(voltage >= 3 && voltage <= 750))
    throw std::invalid_argument("the limits " + name +
                                " name no voltage from 3 to 750 kV; write " +
                                name.substr(0, name.find(':')) + ":110, say");
  return voltage;
}

void
readRow(const std::string& line, const std::string& where, ClearanceLimits& limits)
{
  std::istringstream words(line);
  std::string kind, rest;
  words >> kind;
  Row row;
  HazardKind which;
  try {
    which = fromName<HazardKind>(kind);
  }
  catch (const std::invalid_argument& error) {
    throw std::invalid_argument(where + ": " + error.what());
  }
  if (!(words >> row.high >> row.medium >> row.low) || words >> rest)
    throw std::invalid_argument(where +
                                ": a limit is a kind and three distances (high, "
                                "medium, low severity), as in 'ground 6 7 8'");
  if (!(row.high >= 0 && row.medium >= row.high && row.low >= row.medium &&
        row.low <= 100))
    throw std::invalid_argument(where + ": the distances for high, medium and low "
                                        "severity rise, from 0 to 100 m");
  limits.rows[static_cast<std::size_t>(which)] = row;
}

} // namespace

Severity
ClearanceLimits::severity(HazardKind kind, double distance) const
{
  const Row& row = of(kind);
  return distance < row.high     ? Severity::High
         : distance < row.medium ? Severity::Medium
         : distance < row.low    ? Severity::Low
                                 : Severity::None;
}

double
ClearanceLimits::largest() const
{
  double most = 0;
  for (std::size_t kind = 0; kind < hazard_kinds; ++kind)
    if (static_cast<HazardKind>(kind) != HazardKind::FallIn)
      most = std::max(most, rows[kind].low);
  return most;
}

ClearanceLimits
uniformLimits(double clearance)
{
  ClearanceLimits limits;
  limits.name = textOf(clearance) + " m to everything";
  limits.rows.fill({0.5 * clearance, 0.75 * clearance, clearance});
  limits.rows[static_cast<std::size_t>(HazardKind::FallIn)] = {0, 1, 2};
  return limits;
}

ClearanceLimits
readLimits(const std::string& name_or_file, const ClearanceLimits& otherwise)
{
  if (name_or_file.rfind("en50341:", 0) == 0)
    return europeanLimits(voltageOf(name_or_file, name_or_file.substr(8)));
  if (name_or_file.rfind("nesc:", 0) == 0)
    return americanLimits(voltageOf(name_or_file, name_or_file.substr(5)));
  std::ifstream file(name_or_file);
  if (!file)
    throw io::FileError(name_or_file + ": no such table of limits; name a file, or "
                                       "en50341:KV or nesc:KV with the voltage");
  ClearanceLimits limits = otherwise;
  limits.name = name_or_file;
  std::size_t number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    line = line.substr(0, line.find('#'));
    if (line.find_first_not_of(" \t\r") != std::string::npos)
      readRow(line, name_or_file + ", line " + std::to_string(number), limits);
  }
  if (file.bad())
    throw io::FileError(name_or_file + ": cannot be read; check the file");
  return limits;
}

} // namespace linelet::powerline
