// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/powerline/state_change.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include <linelet/support/text.h>

namespace linelet::powerline {

namespace {

constexpr double gravity = 9.80665; // m/s2, standard
constexpr double glaze = 900;       // kg/m3, EN 50341-1

/** A number with its unit; false for anything else. */
bool
read(const std::string& text, const std::string& unit, double& value)
{
  char* end = nullptr;
  value = std::strtod(text.c_str(), &end);
  return end != text.c_str() && unit == end && std::isfinite(value);
}

/** Total length of the spans without tension. */
double
unstretched(const std::vector<SpanShape>& spans,
            double tension,
            double load,
            double stiffness)
{
  const double a = tension / load;
  double sum = 0;
  for (const SpanShape& span : spans) {
    const double chain = 2 * a * std::sinh(span.length / (2 * a));
    const double length = std::hypot(span.rise, chain);
    const double middle = std::atanh(span.rise / length); // over a
    const double elongation =
        tension / (2 * stiffness) *
        (span.length + a * std::sinh(span.length / a) * std::cosh(2 * middle));
    sum += length - elongation;
  }
  return sum;
}

} // namespace

ConductorState
parseState(const std::string& text)
{
  ConductorState state;
  state.name = text;
  std::istringstream parts(text);
  std::string part;
  bool good = static_cast<bool>(std::getline(parts, part, ',')) &&
              read(part, "C", state.temperature) && state.temperature > -100 &&
              state.temperature < 300;
  while (good && std::getline(parts, part, ','))
    good = (part.rfind("ice=", 0) == 0 && read(part.substr(4), "mm", state.ice) &&
            state.ice >= 0 && state.ice <= 200) ||
           (part.rfind("wind=", 0) == 0 && read(part.substr(5), "Pa", state.wind) &&
            state.wind >= 0 && state.wind <= 5000);
  if (!good)
    throw std::invalid_argument(
        "the state '" + text +
        "' is invalid; write a conductor temperature, then ice and wind if there "
        "are: 75C, or 0C,ice=10mm,wind=400Pa");
  return state;
}

double
ConductorLoad::resultant() const
{
  return std::hypot(vertical, horizontal);
}

double
ConductorLoad::swing() const
{
  return std::atan2(horizontal, vertical) * 180 / M_PI;
}

ConductorLoad
loadOf(const Conductor& conductor, const ConductorState& state)
{
  const double diameter = conductor.diameter / 1000, ice = state.ice / 1000;
  const double sleeve = M_PI * ice * (diameter + ice) * glaze;
  return {gravity * (conductor.mass / 1000 + sleeve),
          state.wind * (diameter + 2 * ice)};
}

double
rulingSpan(const std::vector<SpanShape>& spans)
{
  double cubes = 0, lengths = 0;
  for (const SpanShape& span : spans) {
    cubes += span.length * span.length * span.length;
    lengths += span.length;
  }
  return lengths > 0 ? std::sqrt(cubes / lengths) : 0;
}

double
tensionAfter(const std::vector<SpanShape>& before,
             const std::vector<SpanShape>& after,
             const Conductor& conductor,
             double tension,
             double load,
             double new_load,
             double warming)
{
  const double stiffness = conductor.modulus * 1e9 * conductor.area * 1e-6;
  if (!(tension > 0 && load > 0 && new_load > 0 && stiffness > 0 && !before.empty()))
    throw std::invalid_argument("tension, loads, area and modulus of a conductor must "
                                "be above 0 for another state");
  const double wanted = unstretched(before, tension, load, stiffness) *
                        (1 + conductor.expansion * 1e-6 * warming);
  // The unstretched length falls as the tension rises, so bisect the logarithm of the
  // tension, from a sag of half a span to the strain of the conductor's full modulus.
  double longest = 0;
  for (const SpanShape& span : after)
    longest = std::max(longest, span.length);
  double low = std::log(new_load * longest / 8), high = std::log(stiffness);
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (low + high);
    (unstretched(after, std::exp(middle), new_load, stiffness) > wanted ? low : high) =
        middle;
  }
  return std::exp(0.5 * (low + high));
}

} // namespace linelet::powerline
