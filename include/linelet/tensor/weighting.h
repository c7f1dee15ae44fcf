// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include <linelet/support/names.h>
#include <linelet/support/visibility.h>
#include <linelet/tensor/kernel_table.h>

namespace LINELET_PUBLIC linelet {

/** \brief The weight of a neighbor as a function of x, its distance from the centroid
 * in units of the radius. The ease kernels are 1 minus the easing curve of that name,
 * the cs-rbf kernels compactly supported radial basis functions. linear-inverse,
 * quadratic-inverse and cubic-inverse are capped at 1 up to x = 0.1; inverse-distance
 * (1/x) and inverse-squared-distance (1/x^2; Ritter et al. 2012) are not, and are 0 at
 * the centroid itself. The last two take parameters: FermiDirac is 1 / (e^((x - m) / T)
 * + 1), Step is 1 up to S and 0 beyond. A new kernel is a row in kernel_table.h. */
enum class Kernel {
#define LINELET_KERNEL(kernel, name, support, weight) kernel,
  LINELET_KERNELS(LINELET_KERNEL)
#undef LINELET_KERNEL
};

template <>
struct Names<Kernel> {
  static constexpr std::string_view kind = "weighting";
#define LINELET_KERNEL(kernel, name, support, weight) +1
  static constexpr std::size_t count = 0 LINELET_KERNELS(LINELET_KERNEL);
#undef LINELET_KERNEL
#define LINELET_KERNEL(kernel, name, support, weight) {Kernel::kernel, name},
  static constexpr std::array<std::pair<Kernel, std::string_view>, count> table = {
      {LINELET_KERNELS(LINELET_KERNEL)}};
#undef LINELET_KERNEL
};

/** \brief Where a kernel is nonzero. */
enum class KernelSupport {
  Compact,   ///< x < 1
  Everywhere ///< beyond 1 too
};

constexpr KernelSupport
supportOf(Kernel kernel)
{
  switch (kernel) {
#define LINELET_KERNEL(kernel, name, support, weight)                                  \
  case Kernel::kernel:                                                                 \
    return KernelSupport::support;
    LINELET_KERNELS(LINELET_KERNEL)
#undef LINELET_KERNEL
  }
  return KernelSupport::Everywhere;
}

/** \brief Whether a kernel grows without bound toward x = 0, so that rounding of x
 * decides weights. */
constexpr bool
isUnbounded(Kernel kernel)
{
  return kernel == Kernel::InverseDistance || kernel == Kernel::InverseSquaredDistance;
}

/** \brief A weighting function w(x) of the neighborhood tensor, the centroids and the
 * direction field.
 *
 * Never negative: overshooting curves (elastic, bounce) are clamped to 0. Compact
 * kernels are 0 from x = 1 on; const, the inverse kernels and Fermi-Dirac extend beyond
 * 1. Cheap to copy and to call. */
class Weighting {
public:
  /** \brief fermi-dirac-1, the default weighting of the tensor. */
  Weighting() : Weighting(Kernel::FermiDirac1) {}

  /** \brief A kernel without parameters.
   * \throws std::invalid_argument for Kernel::FermiDirac and Kernel::Step, whose
   * parameters must be given: see \ref fermiDirac and \ref step */
  Weighting(Kernel kernel);

  /** \brief From text: a name of Names<Kernel>, `fermi-dirac:M,T` or `step:S`.
   * \throws std::invalid_argument naming the choices */
  Weighting(std::string_view text);
  Weighting(const char* text) : Weighting(std::string_view(text)) {}
  Weighting(const std::string& text) : Weighting(std::string_view(text)) {}

  /** \brief 1 / (e^((x - m) / temperature) + 1): falls from 1 to 0 around m, over a
   * width of a few \a temperature.
   * \throws std::invalid_argument unless m is finite and temperature positive and
   * finite */
  static Weighting
  fermiDirac(double m, double temperature);

  /** \brief 1 for x <= end, 0 beyond.
   * \throws std::invalid_argument unless \a end is finite and nonnegative */
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

  /** \brief m and T of the Fermi-Dirac kernels (also the numbered ones), S and 0 of
   * Step, otherwise zeros. */
  const std::array<double, 2>&
  parameters() const
  {
    return parameters_;
  }

  /** \brief Text from which the constructor makes this weighting again. */
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
