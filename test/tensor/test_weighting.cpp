// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <linelet/tensor/weighting.h>

using namespace linelet;

namespace {

using std::pow;
using Formula = std::function<double(double)>;

double
rising(double x) // a parabola of equal height for each of four bounces
{
  if (x < 4.0 / 11)
    return 7.5625 * x * x;
  if (x < 8.0 / 11)
    return 9.075 * x * x - 9.9 * x + 3.4;
  if (x < 0.9)
    return 12.066481994459833 * x * x - 19.635457063711911 * x + 8.898060941828255;
  return 10.8 * x * x - 20.52 * x + 10.72;
}

/** \brief A B-spline restated with truncated powers. */
double
plus(double x, int exponent)
{
  return x > 0 ? pow(x, exponent) : 0;
}

/** \brief The kernels by their definition in [0, 1], written independently, without
 * clamping. */
const std::map<std::string, Formula>&
formulas()
{
  static const std::map<std::string, Formula> all = {
      {"const", [](double) { return 1.0; }},
      {"linear", [](double x) { return 1 - x; }},
      {"linear-inverse", [](double x) { return std::fmin(1, 0.1 / x); }},
      {"quadratic", [](double x) { return 1 - pow(x, 2); }},
      {"quadratic-inverse", [](double x) { return std::fmin(1, 0.01 / pow(x, 2)); }},
      {"cubic", [](double x) { return 1 - pow(x, 3); }},
      {"cubic-inverse", [](double x) { return std::fmin(1, 0.001 / pow(x, 3)); }},
      {"inverse-distance", [](double x) { return x == 0 ? 0 : pow(x, -1); }},
      {"inverse-squared-distance", [](double x) { return x == 0 ? 0 : pow(x, -2); }},
      {"sph-3", [](double x) { return 2 * (plus(1 - x, 3) - 4 * plus(0.5 - x, 3)); }},
      {"sph-4",
       [](double x) {
         return pow(2.5, 4) *
                (plus(1 - x, 4) - 5 * plus(0.6 - x, 4) + 10 * plus(0.2 - x, 4));
       }},
      {"sph-5",
       [](double x) {
         return 243 *
                (plus(1 - x, 5) - 6 * plus(2.0 / 3 - x, 5) + 15 * plus(1.0 / 3 - x, 5));
       }},
      {"epanechnikov", [](double x) { return 0.75 - 0.75 * pow(x, 2); }},
      {"ease-bounce",
       [](double x) {
         return x < 0.5 ? 0.5 + rising(1 - 2 * x) / 2 : 0.5 - rising(2 * x - 1) / 2;
       }},
      {"ease-circular",
       [](double x) {
         return x < 0.5 ? 0.5 + std::sqrt(0.25 - x * x)
                        : 0.5 - std::sqrt(std::fmax(0, 0.25 - pow(1 - x, 2)));
       }},
      {"ease-elastic",
       [](double x) {
         return x < 0.5 ? 1 - pow(2, 20 * x - 11) * std::sin(13 * M_PI * x)
                        : pow(2, 9 - 20 * x) * std::sin(13 * M_PI * x);
       }},
      {"ease-exponential",
       [](double x) {
         if (x == 0 || x == 1)
           return 1 - x;
         return x < 0.5 ? 1 - pow(2, 20 * x - 11) : pow(2, 9 - 20 * x);
       }},
      {"ease-sine", [](double x) { return pow(std::cos(M_PI * x / 2), 2); }},
      {"ease-cubic",
       [](double x) { return x < 0.5 ? 1 - 4 * pow(x, 3) : 4 * pow(1 - x, 3); }},
      {"ease-quadratic",
       [](double x) { return x < 0.5 ? 1 - 2 * pow(x, 2) : 2 * pow(1 - x, 2); }},
      {"ease-quintic",
       [](double x) { return x < 0.5 ? 1 - 16 * pow(x, 5) : 16 * pow(1 - x, 5); }},
      {"cs-rbf-1", [](double x) { return 1 - x; }},
      {"cs-rbf-2", [](double x) { return pow(1 - x, 3) * (3 * x + 1); }},
      {"cs-rbf-3", [](double x) { return pow(1 - x, 5) * (8 * x * x + 5 * x + 1); }},
      {"cs-rbf-4", [](double x) { return pow(1 - x, 2); }},
      {"cs-rbf-5", [](double x) { return pow(1 - x, 4) * (4 * x + 1); }},
      {"cs-rbf-6", [](double x) { return pow(1 - x, 6) * (35 * x * x + 18 * x + 3); }},
      {"cs-rbf-7",
       [](double x) {
         return pow(1 - x, 8) * (32 * pow(x, 3) + 25 * x * x + 8 * x + 1);
       }},
      {"cs-rbf-8", [](double x) { return pow(1 - x, 3); }},
      {"cs-rbf-9", [](double x) { return pow(1 - x, 3) * (5 * x + 1); }},
      {"cs-rbf-10", [](double x) { return pow(1 - x, 7) * (16 * x * x + 7 * x + 1); }},
      {"fermi-dirac-1", [](double x) { return 1 / (std::exp(10 * x - 6) + 1); }},
      {"fermi-dirac-2", [](double x) { return 1 / (std::exp(20 * x - 7) + 1); }},
      {"fermi-dirac-3", [](double x) { return 1 / (std::exp(10 * x - 3) + 1); }},
  };
  return all;
}

std::string
messageOf(const std::string& text)
{
  try {
    const Weighting weighting(text);
    return "no error: " + weighting.name();
  }
  catch (const std::invalid_argument& error) {
    return error.what();
  }
}

} // namespace

TEST(Weighting, EveryKernelHasTheValuesOfItsFormula)
{
  ASSERT_EQ(formulas().size(), 34u);
  for (const auto& [name, formula] : formulas()) {
    const Weighting weighting(name);
    for (int i = 0; i <= 1000; ++i) {
      const double x = i / 1000.0;
      const double expected = std::fmax(0, formula(x));
      ASSERT_NEAR(weighting(x), expected, 1e-12 * std::fmax(1, expected))
          << name << " at " << x;
    }
  }
}

TEST(Weighting, EveryNameIsAnEnumeratorAndRoundTrips)
{
  for (const auto& [kernel, name] : Names<Kernel>::table) {
    if (kernel == Kernel::FermiDirac || kernel == Kernel::Step)
      continue;
    EXPECT_EQ(formulas().count(std::string(name)), 1u) << name;
    EXPECT_EQ(Weighting(kernel), Weighting(name));
    EXPECT_EQ(Weighting(kernel).name(), name);
  }
}

TEST(Weighting, ValuesWorkedByHand)
{
  EXPECT_DOUBLE_EQ(Weighting("linear-inverse")(0.5), 0.2);
  EXPECT_DOUBLE_EQ(Weighting("quadratic-inverse")(0.2), 0.25);
  EXPECT_DOUBLE_EQ(Weighting("cubic-inverse")(0.2), 0.125);
  EXPECT_DOUBLE_EQ(Weighting("sph-3")(0.5), 0.25); // where its two pieces meet
  EXPECT_DOUBLE_EQ(Weighting("sph-4")(0), 14.375);
  EXPECT_DOUBLE_EQ(Weighting("sph-5")(0), 66);
  EXPECT_DOUBLE_EQ(Weighting("sph-5")(2.0 / 3), 1);
  EXPECT_DOUBLE_EQ(Weighting("epanechnikov")(0), 0.75);
  EXPECT_DOUBLE_EQ(Weighting("cs-rbf-6")(0), 3);
  for (const char* name : {"fermi-dirac-1", "fermi-dirac:0.6,0.05"})
    EXPECT_DOUBLE_EQ(Weighting(name)(0.6), 0.5) << name;
}

TEST(Weighting, EasingKernelsFallFromOneToZeroWithoutAJump)
{
  for (const char* name : {"ease-bounce",
                           "ease-circular",
                           "ease-elastic",
                           "ease-sine",
                           "ease-cubic",
                           "ease-quadratic",
                           "ease-quintic",
                           "ease-exponential"}) {
    const Weighting weighting(name);
    EXPECT_DOUBLE_EQ(weighting(0), 1) << name;
    EXPECT_EQ(weighting(1), 0) << name;
    // The exponential curve starts and ends 2^-11 away from its end values.
    const double jump = std::string(name) == "ease-exponential" ? 5e-4 : 0;
    // Circular has vertical tangents, so a step of s moves it by about sqrt(s).
    for (double x = 0; x < 1; x += 1e-6)
      ASSERT_NEAR(weighting(x), weighting(x + 1e-6), jump + 1.1e-3)
          << name << " at " << x;
  }
}

TEST(Weighting, SplinesAreContinuousAndEndAtZero)
{
  for (const char* name : {"sph-3", "sph-4", "sph-5"}) {
    const Weighting weighting(name);
    EXPECT_EQ(weighting(1), 0) << name;
    for (double x = 0; x < 1; x += 1e-6)
      ASSERT_NEAR(weighting(x), weighting(x + 1e-6), 3e-4) << name << " at " << x;
  }
}

TEST(Weighting, IsNeverNegativeAndCompactKernelsStayZeroBeyondTheRadius)
{
  for (const auto& [name, formula] : formulas()) {
    const Weighting weighting(name);
    const bool compact = name != "const" && name.find("inverse") == std::string::npos &&
                         name.find("fermi-dirac") == std::string::npos;
    for (int i = 0; i <= 4000; ++i) {
      const double x = i / 2000.0;
      ASSERT_GE(weighting(x), 0) << name << " at " << x;
      if (compact && x >= 1) {
        ASSERT_EQ(weighting(x), 0) << name << " at " << x;
      }
      else if (!compact) {
        ASSERT_NEAR(weighting(x), formula(x), 1e-12) << name << " at " << x;
      }
    }
  }
  // What an overshoot would give: -2^(9-20x) at sin = -1.
  EXPECT_EQ(Weighting("ease-elastic")(7.5 / 13), 0);
}

TEST(Weighting, TakesParameters)
{
  const Weighting free = Weighting::fermiDirac(0.6, 0.1);
  EXPECT_EQ(free.name(), "fermi-dirac:0.6,0.1");
  EXPECT_EQ(Weighting(free.name()), free);
  EXPECT_DOUBLE_EQ(free(0.3), Weighting(Kernel::FermiDirac1)(0.3));
  EXPECT_EQ(Weighting(Kernel::FermiDirac3).parameters(),
            (std::array<double, 2>{0.3, 0.1}));
  EXPECT_EQ(Weighting::fermiDirac(0.5, 1e-4)(50), 0); // e^x beyond double

  const Weighting step("step:0.25");
  EXPECT_EQ(step.name(), "step:0.25");
  EXPECT_EQ(step(0.25), 1);
  EXPECT_EQ(step(std::nextafter(0.25, 1)), 0);
  EXPECT_EQ(Weighting().kernel(), Kernel::FermiDirac1);
}

TEST(Weighting, RefusesUnknownNames)
{
  using testing::HasSubstr;
  EXPECT_THAT(messageOf("gauss"),
              testing::AllOf(HasSubstr("'gauss'"),
                             HasSubstr("cs-rbf-10"),
                             HasSubstr("fermi-dirac:M,T step:S")));
  for (const char* text : {"",
                           ":",
                           "linear:1",
                           "fermi-dirac",
                           "fermi-dirac:",
                           "fermi-dirac:0.6",
                           "fermi-dirac:0.6,0.1,2",
                           "fermi-dirac:0.6,",
                           "fermi-dirac:0.6;0.1",
                           "fermi-dirac:0.6,0",
                           "fermi-dirac:0.6,-1",
                           "fermi-dirac:nan,0.1",
                           "fermi-dirac:0.6,inf",
                           "step",
                           "step:",
                           "step:x",
                           "step:-1",
                           "step:1 ",
                           "Linear"})
    EXPECT_THROW(Weighting{text}, std::invalid_argument) << text;
  EXPECT_THAT(messageOf("fermi-dirac:0.6"), HasSubstr("fermi-dirac:M,T"));
  EXPECT_THROW(Weighting{Kernel::Step}, std::invalid_argument);
}
