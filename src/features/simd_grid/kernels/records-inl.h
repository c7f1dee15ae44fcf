// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From sums of moments to records, a query per lane. Included once per instruction set,
// so it has a guard that toggles.

#if defined(LINELET_GRID_RECORDS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LINELET_GRID_RECORDS_INL
#undef LINELET_GRID_RECORDS_INL
#else
#define LINELET_GRID_RECORDS_INL
#endif

#include <hwy/highway.h>

#include "eigen-inl.h"
#include "lane_moments-inl.h"
#include "sweep_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace linelet::grid {
namespace HWY_NAMESPACE {

/** \brief The tensors of a vector of queries, from \a first on.
 * \param[out] precise those whose float sums give shape factors to 1e-4, one bit each
 */
HWY_INLINE EigenLanes
tensorsOf(const QuerySums& sums,
          const RecordSettings& settings,
          std::size_t first,
          std::uint32_t& precise)
{
  const D d;
  const VD zero = hn::Zero(d);
  const auto real =
      hn::FirstN(d, first < sums.count ? sums.count - first : std::size_t{0});
  const auto load = [&](const double* entries)
                        HWY_ATTR { return hn::MaskedLoad(real, d, entries + first); };
  const auto sum = [&](std::size_t m) HWY_ATTR { return load(sums.moments[m]); };
  LaneMoments m{
      sum(0), sum(1), sum(2), sum(3), sum(4), sum(5), sum(6), sum(7), sum(8), sum(9)};
  m.moveTo(load(sums.query[0]), load(sums.query[1]), load(sums.query[2]));
  const VD spread = m.trace();
  VD inverse =
      hn::IfThenElseZero(hn::Gt(m.total, zero), hn::Div(hn::Set(d, 1), m.total));
  if (settings.mean)
    m.moveTo(hn::Mul(m.x, inverse), hn::Mul(m.y, inverse), hn::Mul(m.z, inverse));

  constexpr double wanted = 3e-5, rounding = 5e-7;
  const VD trace = m.trace();
  // Errors of single weights are rounding, and add up as such.
  VD error = hn::Mul(hn::Set(d, 4 * settings.weight_error.absolute),
                     hn::Sqrt(load(sums.found)));
  error =
      hn::MulAdd(hn::Set(d, settings.weight_error.relative + rounding), spread, error);
  error = hn::MulAdd(hn::Set(d, settings.coordinate_error),
                     hn::Sqrt(hn::Max(zero, hn::Mul(m.total, trace))),
                     error);
  auto good = hn::And(hn::Gt(trace, zero), hn::Gt(m.total, zero));
  good = hn::And(good, hn::Le(error, hn::Mul(hn::Set(d, wanted), trace)));
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, good, bits);
  precise = bits[0];

  // Neighbors without any weight leave a tensor of 0, which is not precise.
  if (settings.by_count)
    inverse = hn::Div(hn::Set(d, 1), hn::Max(hn::Set(d, 1), load(sums.found)));
  EigenLanes tensors;
  tensors.xx = hn::Mul(m.xx, inverse);
  tensors.xy = hn::Mul(m.xy, inverse);
  tensors.xz = hn::Mul(m.xz, inverse);
  tensors.yy = hn::Mul(m.yy, inverse);
  tensors.yz = hn::Mul(m.yz, inverse);
  tensors.zz = hn::Mul(m.zz, inverse);
  return tensors;
}

std::uint32_t
records(const QuerySums& sums,
        const RecordSettings& settings,
        std::size_t first,
        RecordLanes& out)
{
  const D d;
  const hn::Rebind<float, D> half;
  const std::size_t lanes = hn::Lanes(d);
  std::uint32_t good = 0;
  for (std::size_t q = 0; q < RecordLanes::queries; q += 2 * lanes) {
    std::uint32_t precise[2];
    EigenLanes pair[2] = {tensorsOf(sums, settings, first + q, precise[0]),
                          tensorsOf(sums, settings, first + q + lanes, precise[1])};
    good |= precise[0] << q | precise[1] << (q + lanes);
    const auto put = [&](std::size_t entry, std::size_t k, VD value) HWY_ATTR {
      hn::StoreU(
          hn::DemoteTo(half, value), half, out.entry[entry].data() + q + k * lanes);
    };
    const VD area = hn::Set(d, settings.area);
    for (std::size_t k = 0; k < 2; ++k) {
      put(0, k, hn::Mul(pair[k].xx, area));
      put(1, k, hn::Mul(pair[k].xy, area));
      put(2, k, hn::Mul(pair[k].xz, area));
      put(3, k, hn::Mul(pair[k].yy, area));
      put(4, k, hn::Mul(pair[k].yz, area));
      put(5, k, hn::Mul(pair[k].zz, area));
    }
    analyze(pair[0], pair[1]);
    for (std::size_t k = 0; k < 2; ++k) {
      const EigenLanes& e = pair[k];
      const VD scale = hn::Mul(e.trace, area);
      put(6, k, hn::Mul(e.xx, scale));
      put(7, k, hn::Mul(e.yy, scale));
      put(8, k, hn::Mul(e.zz, scale));
      put(9, k, e.w.x);
      put(10, k, e.w.y);
      put(11, k, e.w.z);
      put(12, k, e.u.x);
      put(13, k, e.u.y);
      put(14, k, e.u.z);
      const VD inverse = hn::Div(hn::Set(d, 1), hn::Add(e.xx, hn::Add(e.yy, e.zz)));
      put(15, k, hn::Mul(hn::Sub(e.zz, e.yy), inverse));
      put(16, k, hn::Mul(hn::Mul(hn::Set(d, 2), hn::Sub(e.yy, e.xx)), inverse));
      put(17, k, hn::Mul(hn::Mul(hn::Set(d, 3), e.xx), inverse));
    }
  }
  return good;
}

} // namespace HWY_NAMESPACE
} // namespace linelet::grid
HWY_AFTER_NAMESPACE();

#endif
