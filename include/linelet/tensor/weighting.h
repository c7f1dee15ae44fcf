// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <string>
#include <string_view>

#include <linelet/support/names.h>

namespace linelet {

/** \brief How much a neighbor counts, by its distance x from the centroid in units of
 * the radius. Kernels 12 to 19 are 1 minus the easing curve of that name, 20 to 29
 * compactly supported radial basis functions; the last two take parameters. */
enum class Kernel {
  Const,
  Linear,
  LinearInverse,
  Quadratic,
  QuadraticInverse,
  Cubic,
  CubicInverse,
  Sph3,
  Sph4,
  Sph5,
  Epanechnikov,
  EaseBounce,
  EaseCircular,
  EaseElastic,
  EaseExponential,
  EaseSine,
  EaseCubic,
  EaseQuadratic,
  EaseQuintic,
  CsRbf1,
  CsRbf2,
  CsRbf3,
  CsRbf4,
  CsRbf5,
  CsRbf6,
  CsRbf7,
  CsRbf8,
  CsRbf9,
  CsRbf10,
  FermiDirac1,
  FermiDirac2,
  FermiDirac3,
  FermiDirac, ///< 1 / (e^((x - m) / T) + 1) with m and T given
  Step        ///< 1 up to S, 0 beyond
};

template <>
struct Names<Kernel> {
  static constexpr std::string_view kind = "weighting";
  static constexpr std::array<std::pair<Kernel, std::string_view>, 34> table = {{
      {Kernel::Const, "const"},
      {Kernel::Linear, "linear"},
      {Kernel::LinearInverse, "linear-inverse"},
      {Kernel::Quadratic, "quadratic"},
      {Kernel::QuadraticInverse, "quadratic-inverse"},
      {Kernel::Cubic, "cubic"},
      {Kernel::CubicInverse, "cubic-inverse"},
      {Kernel::Sph3, "sph-3"},
      {Kernel::Sph4, "sph-4"},
      {Kernel::Sph5, "sph-5"},
      {Kernel::Epanechnikov, "epanechnikov"},
      {Kernel::EaseBounce, "ease-bounce"},
      {Kernel::EaseCircular, "ease-circular"},
      {Kernel::EaseElastic, "ease-elastic"},
      {Kernel::EaseExponential, "ease-exponential"},
      {Kernel::EaseSine, "ease-sine"},
      {Kernel::EaseCubic, "ease-cubic"},
      {Kernel::EaseQuadratic, "ease-quadratic"},
      {Kernel::EaseQuintic, "ease-quintic"},
      {Kernel::CsRbf1, "cs-rbf-1"},
      {Kernel::CsRbf2, "cs-rbf-2"},
      {Kernel::CsRbf3, "cs-rbf-3"},
      {Kernel::CsRbf4, "cs-rbf-4"},
      {Kernel::CsRbf5, "cs-rbf-5"},
      {Kernel::CsRbf6, "cs-rbf-6"},
      {Kernel::CsRbf7, "cs-rbf-7"},
      {Kernel::CsRbf8, "cs-rbf-8"},
      {Kernel::CsRbf9, "cs-rbf-9"},
      {Kernel::CsRbf10, "cs-rbf-10"},
      {Kernel::FermiDirac1, "fermi-dirac-1"},
      {Kernel::FermiDirac2, "fermi-dirac-2"},
      {Kernel::FermiDirac3, "fermi-dirac-3"},
      {Kernel::FermiDirac, "fermi-dirac"},
      {Kernel::Step, "step"},
  }};
};

/** \brief A weighting function w(x) of the neighborhood tensor, the centroids and the
 * direction field.
 *
 * Never negative: where a curve overshoots (elastic, bounce) it is clamped to 0.
 * Compact kernels are 0 from x = 1 on; const, the inverse kernels and Fermi-Dirac are
 * evaluated beyond 1 as they are. Small, cheap to copy and to call. */
class Weighting {
public:
  /** \brief fermi-dirac-1, the weighting of the tensor unless another is asked for. */
  Weighting() : Weighting(Kernel::FermiDirac1) {}

  /** \brief A kernel without parameters.
   * \throws std::invalid_argument for Kernel::FermiDirac and Kernel::Step, whose
   * parameters must be given: see \ref fermiDirac and \ref step */
  Weighting(Kernel kernel);

  /** \brief By text: a name of Names<Kernel>, `fermi-dirac:M,T` or `step:S`.
   * \throws std::invalid_argument naming the choices */
  Weighting(std::string_view text);
  Weighting(const char* text) : Weighting(std::string_view(text)) {}
  Weighting(const std::string& text) : Weighting(std::string_view(text)) {}

  /** \brief 1 / (e^((x - m) / temperature) + 1): falls from 1 to 0 around m, over a
   * width of a few \a temperature.
   * \throws std::invalid_argument unless m is finite and temperature positive, finite
   */
  static Weighting
  fermiDirac(double m, double temperature);

  /** \brief 1 for x <= end, 0 beyond.
   * \throws std::invalid_argument unless \a end is finite and not negative */
  static Weighting
  step(double end);

  /** \brief w(x) for x >= 0. */
  double
  operator()(double x) const;

  Kernel
  kernel() const
  {
    return kernel_;
  }

  /** \brief m and T where \ref kernel is one of the Fermi-Dirac kernels (the numbered
   * ones as well), S and 0 for Step, else zeros. */
  const std::array<double, 2>&
  parameters() const
  {
    return parameters_;
  }

  /** \brief Text that makes this weighting again. */
  std::string
  name() const;

  friend bool
  operator==(const Weighting& a, const Weighting& b)
  {
    return a.kernel_ == b.kernel_ && a.parameters_ == b.parameters_;
  }
  friend bool
  operator!=(const Weighting& a, const Weighting& b)
  {
    return !(a == b);
  }

private:
  Weighting(Kernel kernel, double first, double second)
      : kernel_(kernel), parameters_{first, second}
  {
  }

  Kernel kernel_;
  std::array<double, 2> parameters_{};
};

} // namespace linelet
