// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

// clang-format off

/** \brief The kernels of linelet::Weighting: enumerator, name, support, w(x).
 *
 * The weight is an expression in x, y = 1 - x, and the parameters first and second. A
 * compact kernel is evaluated on [0, 1) and 0 beyond. Its vector form is in
 * src/features/simd_grid/kernels/weights-inl.h (which does not compile without one),
 * its OpenCL form in src/opencl/kernels/weights.cl (where a missing one gives NaN). */
#define LINELET_KERNELS(KERNEL) \
  KERNEL(Const, "const", Everywhere, 1)                                                        \
  KERNEL(Linear, "linear", Compact, y)                                                         \
  KERNEL(LinearInverse, "linear-inverse", Everywhere, x <= 0.1 ? 1 : 0.1 / x)                  \
  KERNEL(Quadratic, "quadratic", Compact, 1 - x * x)                                           \
  KERNEL(QuadraticInverse, "quadratic-inverse", Everywhere, x <= 0.1 ? 1 : power(0.1 / x, 2))  \
  KERNEL(Cubic, "cubic", Compact, 1 - power(x, 3))                                             \
  KERNEL(CubicInverse, "cubic-inverse", Everywhere, x <= 0.1 ? 1 : power(0.1 / x, 3))          \
  KERNEL(InverseDistance, "inverse-distance", Everywhere, x > 0 ? 1 / x : 0)                    \
  KERNEL(InverseSquaredDistance, "inverse-squared-distance", Everywhere,                       \
         x > 0 ? 1 / (x * x) : 0)                                                              \
  KERNEL(Sph3, "sph-3", Compact, sph3(x))                                                      \
  KERNEL(Sph4, "sph-4", Compact, sph4(x))                                                      \
  KERNEL(Sph5, "sph-5", Compact, sph5(x))                                                      \
  KERNEL(Epanechnikov, "epanechnikov", Compact, 0.75 * (1 - x * x))                            \
  KERNEL(EaseBounce, "ease-bounce", Compact, easeBounce(x))                                    \
  KERNEL(EaseCircular, "ease-circular", Compact, easeCircular(x))                              \
  KERNEL(EaseElastic, "ease-elastic", Compact, easeElastic(x))                                 \
  KERNEL(EaseExponential, "ease-exponential", Compact, easeExponential(x))                     \
  KERNEL(EaseSine, "ease-sine", Compact, (1 + std::cos(pi * x)) / 2)                           \
  KERNEL(EaseCubic, "ease-cubic", Compact, easeCubic(x))                                       \
  KERNEL(EaseQuadratic, "ease-quadratic", Compact, easeQuadratic(x))                           \
  KERNEL(EaseQuintic, "ease-quintic", Compact, easeQuintic(x))                                 \
  KERNEL(CsRbf1, "cs-rbf-1", Compact, y)                                                       \
  KERNEL(CsRbf2, "cs-rbf-2", Compact, power(y, 3) * (3 * x + 1))                               \
  KERNEL(CsRbf3, "cs-rbf-3", Compact, power(y, 5) * ((8 * x + 5) * x + 1))                     \
  KERNEL(CsRbf4, "cs-rbf-4", Compact, y * y)                                                   \
  KERNEL(CsRbf5, "cs-rbf-5", Compact, power(y, 4) * (4 * x + 1))                               \
  KERNEL(CsRbf6, "cs-rbf-6", Compact, power(y, 6) * ((35 * x + 18) * x + 3))                   \
  KERNEL(CsRbf7, "cs-rbf-7", Compact, power(y, 8) * (((32 * x + 25) * x + 8) * x + 1))         \
  KERNEL(CsRbf8, "cs-rbf-8", Compact, power(y, 3))                                             \
  KERNEL(CsRbf9, "cs-rbf-9", Compact, power(y, 3) * (5 * x + 1))                               \
  KERNEL(CsRbf10, "cs-rbf-10", Compact, power(y, 7) * ((16 * x + 7) * x + 1))                  \
  KERNEL(FermiDirac1, "fermi-dirac-1", Everywhere, fermiDiracAt(x, first, second))               \
  KERNEL(FermiDirac2, "fermi-dirac-2", Everywhere, fermiDiracAt(x, first, second))               \
  KERNEL(FermiDirac3, "fermi-dirac-3", Everywhere, fermiDiracAt(x, first, second))               \
  KERNEL(FermiDirac, "fermi-dirac", Everywhere, fermiDiracAt(x, first, second))                  \
  KERNEL(Step, "step", Everywhere, x <= first ? 1 : 0)

// clang-format on
