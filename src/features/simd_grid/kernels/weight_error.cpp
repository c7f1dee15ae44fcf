// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "weight_error.h"

namespace linelet::grid {

WeightError
weightError(const Weighting& weighting)
{
  constexpr double rounding = 0x1p-24;
  switch (weighting.kernel()) {
  case Kernel::Const:
    return {0, 0};
  case Kernel::LinearInverse:
  case Kernel::QuadraticInverse:
  case Kernel::CubicInverse:
  case Kernel::InverseDistance:
  case Kernel::InverseSquaredDistance:
    return {0, 1e-6};
  case Kernel::FermiDirac1:
  case Kernel::FermiDirac2:
  case Kernel::FermiDirac3:
  case Kernel::FermiDirac:
    // The exponent is in units of the temperature.
    return {0, 5e-7 + 4 * rounding / weighting.parameters()[1]};
  case Kernel::EaseBounce: // differences of numbers of about 5
    return {2e-6, 1e-6};
  case Kernel::EaseElastic: // a sine of up to 13 pi
    return {2e-6, 1e-6};
  default:
    // They end in 0, where rounding of x is all that counts.
    return {4 * rounding * weighting(0), 1e-6};
  }
}

} // namespace linelet::grid
