// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/powerline/conductor_types.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <linelet/io/file_error.h>

namespace linelet::powerline {

namespace {

/** The member that a key of a file sets; null: no such key. */
double*
member(Conductor& conductor, const std::string& key)
{
  const std::pair<const char*, double*> members[] = {
      {"area", &conductor.area},
      {"diameter", &conductor.diameter},
      {"mass", &conductor.mass},
      {"modulus", &conductor.modulus},
      {"expansion", &conductor.expansion},
      {"creep", &conductor.creep}};
  for (const auto& [name, value] : members)
    if (key == name)
      return value;
  return nullptr;
}

void
readLine(const std::string& line, const std::string& where, Conductor& conductor)
{
  std::istringstream words(line);
  std::string key, rest;
  words >> key;
  if (key == "name") {
    words >> conductor.name;
    return;
  }
  double* value = member(conductor, key);
  if (value == nullptr)
    throw std::invalid_argument(where + ": there is no property " + key +
                                " of a conductor; write area, diameter, mass, modulus, "
                                "expansion, creep or name");
  if (!(words >> *value) || words >> rest || !std::isfinite(*value))
    throw std::invalid_argument(where + ": " + key + " needs one number");
}

} // namespace

const std::vector<Conductor>&
knownConductors()
{
  static const std::vector<Conductor> types = {
      // ACSR, ASTM B 232: 26/7, 54/7 and 45/7 strands.
      {"Linnet", 198.3, 18.29, 689, 77, 18.9},
      {"Hawk", 281.0, 21.79, 976, 77, 18.9},
      {"Dove", 328.0, 23.55, 1140, 77, 18.9},
      {"Grosbeak", 374.8, 25.15, 1302, 77, 18.9},
      {"Drake", 468.4, 28.14, 1628, 77, 18.9},
      {"Cardinal", 546.0, 30.38, 1829, 70, 19.3},
      {"Rail", 516.8, 29.59, 1600, 61, 20.9},
      {"Bluejay", 603.0, 31.98, 1868, 61, 20.9},
      {"Bittern", 689.0, 34.16, 2134, 61, 20.9},
      // Al/St, DIN 48204: 6/1, 26/7, 24/7 and 54/7 strands.
      {"50/8", 56.3, 9.6, 196, 81, 19.2},
      {"70/12", 81.3, 11.7, 284, 77, 18.9},
      {"95/15", 109.7, 13.6, 383, 77, 18.9},
      {"120/20", 141.4, 15.5, 494, 77, 18.9},
      {"185/30", 213.6, 19.0, 744, 77, 18.9},
      {"240/40", 282.5, 21.8, 987, 77, 18.9},
      {"265/35", 297.8, 22.4, 998, 74, 19.6},
      {"435/55", 490.6, 28.8, 1647, 70, 19.3},
      // AAAC, ASTM B 399 (alloy 6201-T81): 19 and 37 strands.
      {"Butte", 158.6, 16.31, 437, 57, 23},
      {"Canton", 199.9, 18.31, 551, 57, 23},
      {"Flint", 375.4, 25.16, 1034, 57, 23},
      {"Greeley", 469.8, 28.15, 1295, 57, 23}};
  return types;
}

Conductor
readConductor(const std::string& name_or_file)
{
  std::string names;
  for (const Conductor& known : knownConductors()) {
    if (known.name == name_or_file)
      return known;
    names += (names.empty() ? "" : ", ") + known.name;
  }
  std::ifstream file(name_or_file);
  if (!file)
    throw io::FileError(name_or_file +
                        ": neither a file nor a known conductor; known are " + names);
  Conductor conductor;
  conductor.name = name_or_file;
  std::size_t number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    line = line.substr(0, line.find('#'));
    if (line.find_first_not_of(" \t\r") != std::string::npos)
      readLine(line, name_or_file + ", line " + std::to_string(number), conductor);
  }
  for (const char* key : {"area", "diameter", "mass", "modulus"})
    if (!(*member(conductor, key) > 0))
      throw std::invalid_argument(name_or_file + ": " + key +
                                  " must be given, above 0");
  return conductor;
}

} // namespace linelet::powerline
