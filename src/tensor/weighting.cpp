// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/tensor/weighting.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace linelet {

namespace {

constexpr double pi = M_PI; // of the table

double
power(double base, int exponent)
{
  double result = 1;
  for (; exponent > 0; --exponent)
    result *= base;
  return result;
}

/** \brief Penner's bounce, rising from 0 to 1. */
double
bounce(double x)
{
  if (x < 4.0 / 11)
    return 121.0 / 16 * x * x;
  if (x < 8.0 / 11)
    return (363.0 / 40 * x - 99.0 / 10) * x + 17.0 / 5;
  if (x < 9.0 / 10)
    return (4356.0 / 361 * x - 35442.0 / 1805) * x + 16061.0 / 1805;
  return (54.0 / 5 * x - 513.0 / 25) * x + 268.0 / 25;
}

/** \brief Cubic, quartic and quintic B-splines of smoothed particle hydrodynamics. */
double
sph3(double x)
{
  const double a = 2 * x;
  return a < 1 ? 1 - 1.5 * a * a + 0.75 * power(a, 3) : 0.25 * power(2 - a, 3);
}

double
sph4(double x)
{
  const double b = 2.5 * x;
  double sum = power(2.5 - b, 4);
  if (b < 1.5)
    sum -= 5 * power(1.5 - b, 4);
  if (b < 0.5)
    sum += 10 * power(0.5 - b, 4);
  return sum;
}

double
sph5(double x)
{
  const double c = 3 * x;
  double sum = power(3 - c, 5);
  if (c < 2)
    sum -= 6 * power(2 - c, 5);
  if (c < 1)
    sum += 15 * power(1 - c, 5);
  return sum;
}

/** \name Easing
 * 1 minus an easing curve that is symmetric about (1/2, 1/2); x in [0, 1). */
///@{

double
easeBounce(double x)
{
  return 1 - (x < 0.5 ? (1 - bounce(1 - 2 * x)) / 2 : (1 + bounce(2 * x - 1)) / 2);
}

double
easeCircular(double x)
{
  return 1 - (x < 0.5 ? (1 - std::sqrt(1 - 4 * x * x)) / 2
                      : (std::sqrt((3 - 2 * x) * (2 * x - 1)) + 1) / 2);
}

double
easeElastic(double x)
{
  return 1 - (x < 0.5
                  ? 0.5 * std::sin(13 * pi * x) * std::exp2(10 * (2 * x - 1))
                  : 0.5 * (std::sin(-13 * pi * x) * std::exp2(-10 * (2 * x - 1)) + 2));
}

double
easeExponential(double x)
{
  return x == 0 ? 1
                : 1 - (x < 0.5 ? std::exp2(20 * x - 10) / 2
                               : 1 - std::exp2(10 - 20 * x) / 2);
}

double
easeCubic(double x)
{
  return 1 - (x < 0.5 ? 4 * power(x, 3) : power(2 * x - 2, 3) / 2 + 1);
}

double
easeQuadratic(double x)
{
  return 1 - (x < 0.5 ? 2 * x * x : (4 - 2 * x) * x - 1);
}

double
easeQuintic(double x)
{
  return 1 - (x < 0.5 ? 16 * power(x, 5) : power(2 * x - 2, 5) / 2 + 1);
}

///@}

double
fermiDiracAt(double x, double m, double temperature)
{
  return 1 / (std::exp((x - m) / temperature) + 1);
}

/** \brief The comma-separated numbers of \a text; empty if it is not such a list. */
std::vector<double>
numbers(std::string_view text)
{
  std::vector<double> values;
  const char *at = text.data(), *const end = at + text.size();
  while (true) {
    double value = 0;
    const auto [rest, error] = std::from_chars(at, end, value);
    if (error != std::errc())
      return {};
    values.push_back(value);
    if (rest == end)
      return values;
    if (*rest != ',')
      return {};
    at = rest + 1;
  }
}

std::string
shortest(double value)
{
  std::array<char, 32> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), result.ptr};
}

Kernel
kernelCalled(std::string_view name)
{
  std::string message = "unknown weighting '" + std::string(name) + "', use one of";
  for (const auto& [kernel, known] : Names<Kernel>::table) {
    if (name == known)
      return kernel;
    message += " " + std::string(known);
    if (kernel == Kernel::FermiDirac)
      message += ":M,T";
    else if (kernel == Kernel::Step)
      message += ":S";
  }
  throw std::invalid_argument(message);
}

} // namespace

Weighting::Weighting(Kernel kernel) : kernel_(kernel)
{
  if (kernel == Kernel::FermiDirac1)
    parameters_ = {0.6, 0.1};
  else if (kernel == Kernel::FermiDirac2)
    parameters_ = {0.35, 0.05};
  else if (kernel == Kernel::FermiDirac3)
    parameters_ = {0.3, 0.1};
  else if (kernel == Kernel::FermiDirac)
    throw std::invalid_argument("weighting fermi-dirac needs its parameters, "
                                "fermi-dirac:M,T (for example fermi-dirac:0.6,0.1)");
  else if (kernel == Kernel::Step)
    throw std::invalid_argument(
        "weighting step needs its parameter, step:S (for example step:0.5)");
}

Weighting::Weighting(std::string_view text) : Weighting()
{
  const std::size_t colon = text.find(':');
  const Kernel kernel = kernelCalled(text.substr(0, colon));
  if (colon == std::string_view::npos) {
    *this = Weighting(kernel);
    return;
  }
  const std::vector<double> values = numbers(text.substr(colon + 1));
  if (kernel == Kernel::FermiDirac && values.size() == 2)
    *this = fermiDirac(values[0], values[1]);
  else if (kernel == Kernel::Step && values.size() == 1)
    *this = step(values[0]);
  else
    throw std::invalid_argument(
        "weighting '" + std::string(text) +
        "' is unknown; those with parameters are fermi-dirac:M,T and step:S");
}

Weighting
Weighting::fermiDirac(double m, double temperature)
{
  if (!std::isfinite(m) || !std::isfinite(temperature) || !(temperature > 0))
    throw std::invalid_argument("weighting fermi-dirac:" + shortest(m) + "," +
                                shortest(temperature) +
                                ": M must be finite, T positive and finite");
  return {Kernel::FermiDirac, m, temperature};
}

Weighting
Weighting::step(double end)
{
  if (!std::isfinite(end) || !(end >= 0))
    throw std::invalid_argument("weighting step:" + shortest(end) +
                                ": S must be finite and not negative");
  return {Kernel::Step, end, 0};
}

double
Weighting::operator()(double x) const
{
  [[maybe_unused]] const double y = 1 - x;
  const auto [first, second] = parameters_;
  switch (kernel_) {
#define LINELET_KERNEL(kernel, name, support, weight)                                  \
  case Kernel::kernel:                                                                 \
    if constexpr (KernelSupport::support == KernelSupport::Compact)                    \
      return x < 1 ? std::max(0.0, static_cast<double>(weight)) : 0;                   \
    else                                                                               \
      return weight;
    LINELET_KERNELS(LINELET_KERNEL)
#undef LINELET_KERNEL
  }
  return 0;
}

std::string
Weighting::name() const
{
  std::string text(nameOf(kernel_));
  if (kernel_ == Kernel::FermiDirac)
    text += ":" + shortest(parameters_[0]) + "," + shortest(parameters_[1]);
  else if (kernel_ == Kernel::Step)
    text += ":" + shortest(parameters_[0]);
  return text;
}

} // namespace linelet
