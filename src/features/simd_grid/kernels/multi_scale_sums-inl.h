// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sums and weights of pairs of points and queries, a query per lane. Included once per
// instruction set, so it has a guard that toggles.

#if defined(LINELET_GRID_MULTI_SCALE_SUMS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LINELET_GRID_MULTI_SCALE_SUMS_INL
#undef LINELET_GRID_MULTI_SCALE_SUMS_INL
#else
#define LINELET_GRID_MULTI_SCALE_SUMS_INL
#endif

#include <hwy/highway.h>

#include "multi_scale_kernels.h"
#include "multi_scale_lists-inl.h"
#include "table-inl.h"

HWY_BEFORE_NAMESPACE();
namespace linelet::grid {
namespace HWY_NAMESPACE {

/** \brief Points summed in float before the sum continues in double. */
constexpr std::size_t chunk_points = 64;

/** \brief Some points of a list, and the products of their coordinates. */
struct Chunk {
  const float *x, *y, *z;
  std::size_t first, size;
  alignas(64) float xx[chunk_points], xy[chunk_points], xz[chunk_points],
      yy[chunk_points], yz[chunk_points], zz[chunk_points];

  HWY_INLINE
  Chunk(const PointList& list, std::size_t begin, std::size_t end, bool products)
      : x(list.x + begin),
        y(list.y + begin),
        z(list.z + begin),
        first(begin),
        size(end - begin)
  {
    const F f;
    if (products)
      for (std::size_t i = 0; i < size; i += hn::Lanes(f)) {
        const V a = hn::LoadU(f, x + i), b = hn::LoadU(f, y + i),
                c = hn::LoadU(f, z + i);
        hn::Store(hn::Mul(a, a), f, xx + i);
        hn::Store(hn::Mul(a, b), f, xy + i);
        hn::Store(hn::Mul(a, c), f, xz + i);
        hn::Store(hn::Mul(b, b), f, yy + i);
        hn::Store(hn::Mul(b, c), f, yz + i);
        hn::Store(hn::Mul(c, c), f, zz + i);
      }
  }
};

/** \brief Values for every pair of a chunk and a vector of queries. */
struct PairBuffer {
  alignas(64) float value[chunk_points * leaf_queries];
};

/** \brief Positions of a vector of queries. */
struct QueryVector {
  V x, y, z;

  HWY_INLINE
  QueryVector(const LeafQueries& queries, std::size_t q)
      : x(hn::Load(F(), queries.x.lane + q)),
        y(hn::Load(F(), queries.y.lane + q)),
        z(hn::Load(F(), queries.z.lane + q))
  {
  }

  HWY_INLINE V
  squaredFrom(const Chunk& chunk, std::size_t c) const
  {
    const V dx = hn::Sub(constant(chunk.x[c]), x),
            dy = hn::Sub(constant(chunk.y[c]), y),
            dz = hn::Sub(constant(chunk.z[c]), z);
    return hn::MulAdd(dx, dx, hn::MulAdd(dy, dy, hn::Mul(dz, dz)));
  }
};

/** \brief Sums of a vector of queries, in float. */
struct PairSums {
  V total, x, y, z, xx, xy, xz, yy, yz, zz, found;

  HWY_INLINE
  PairSums()
  {
    total = x = y = z = xx = xy = xz = yy = yz = zz = found = hn::Zero(F());
  }

  /** \brief Point \a c about the origin of the chunk. */
  template <bool second>
  HWY_INLINE void
  add(V w, const Chunk& chunk, std::size_t c)
  {
    total = hn::Add(total, w);
    x = hn::MulAdd(w, constant(chunk.x[c]), x);
    y = hn::MulAdd(w, constant(chunk.y[c]), y);
    z = hn::MulAdd(w, constant(chunk.z[c]), z);
    if constexpr (second) {
      xx = hn::MulAdd(w, constant(chunk.xx[c]), xx);
      xy = hn::MulAdd(w, constant(chunk.xy[c]), xy);
      xz = hn::MulAdd(w, constant(chunk.xz[c]), xz);
      yy = hn::MulAdd(w, constant(chunk.yy[c]), yy);
      yz = hn::MulAdd(w, constant(chunk.yz[c]), yz);
      zz = hn::MulAdd(w, constant(chunk.zz[c]), zz);
    }
  }

  /** \brief The same with weight 1 where \a mask is. */
  template <class Mask>
  HWY_INLINE void
  addMasked(Mask mask, const Chunk& chunk, std::size_t c)
  {
    const V px = constant(chunk.x[c]), py = constant(chunk.y[c]),
            pz = constant(chunk.z[c]);
    const auto add = [&](V& s, V a)
                         HWY_ATTR { s = hn::IfThenElse(mask, hn::Add(s, a), s); };
    // Products are cheaper than loads of them.
    const auto addProduct = [&](V& s, V a, V b) HWY_ATTR {
      s = hn::IfThenElse(mask, hn::MulAdd(a, b, s), s);
    };
    add(total, constant(1));
    add(x, px);
    add(y, py);
    add(z, pz);
    addProduct(xx, px, px);
    addProduct(xy, px, py);
    addProduct(xz, px, pz);
    addProduct(yy, py, py);
    addProduct(yz, py, pz);
    addProduct(zz, pz, pz);
  }

  /** \brief Point \a c about positions \a from. */
  HWY_INLINE void
  addAbout(V w, const Chunk& chunk, std::size_t c, const QueryVector& from)
  {
    const V dx = hn::Sub(constant(chunk.x[c]), from.x),
            dy = hn::Sub(constant(chunk.y[c]), from.y),
            dz = hn::Sub(constant(chunk.z[c]), from.z);
    const V wx = hn::Mul(w, dx), wy = hn::Mul(w, dy), wz = hn::Mul(w, dz);
    total = hn::Add(total, w);
    x = hn::Add(x, wx);
    y = hn::Add(y, wy);
    z = hn::Add(z, wz);
    xx = hn::MulAdd(wx, dx, xx);
    xy = hn::MulAdd(wx, dy, xy);
    xz = hn::MulAdd(wx, dz, xz);
    yy = hn::MulAdd(wy, dy, yy);
    yz = hn::MulAdd(wy, dz, yz);
    zz = hn::MulAdd(wz, dz, zz);
  }

  HWY_INLINE void
  addTo(ScaleSums& sums, std::size_t q) const
  {
    put(total, sums.sum[Total], q);
    put(x, sums.sum[X], q);
    put(y, sums.sum[Y], q);
    put(z, sums.sum[Z], q);
    put(xx, sums.sum[XX], q);
    put(xy, sums.sum[XY], q);
    put(xz, sums.sum[XZ], q);
    put(yy, sums.sum[YY], q);
    put(yz, sums.sum[YZ], q);
    put(zz, sums.sum[ZZ], q);
    const F f;
    hn::Store(hn::Add(found, hn::Load(f, sums.found.lane + q)), f, sums.found.lane + q);
  }

private:
  static HWY_INLINE void
  put(V values, Lanes<double>& sum, std::size_t q)
  {
    const hn::ScalableTag<double> d;
    const hn::Rebind<float, hn::ScalableTag<double>> half;
    const std::size_t lanes = hn::Lanes(d);
    alignas(64) float buffer[leaf_queries];
    hn::Store(values, F(), buffer);
    for (std::size_t i = 0; i < hn::Lanes(F()); i += lanes) {
      double* const at = sum.lane + q + i;
      hn::Store(hn::Add(hn::Load(d, at), hn::PromoteTo(d, hn::Load(half, buffer + i))),
                d,
                at);
    }
  }
};

/** \brief w of the pairs of a buffer, by squared distances and distances. */
using PairWeights = void (*)(const Weighting& weighting,
                             const float* squared,
                             const float* distance,
                             float inverse_radius,
                             std::size_t count,
                             float* weight);

template <class W, Kernel kernel>
HWY_INLINE V
weightAt(const W& weight, V squared, V distance, V inverse, V inverse_squared)
{
  if constexpr (kernel == Kernel::Const || kernel == Kernel::Quadratic ||
                kernel == Kernel::Epanechnikov || kernel == Kernel::QuadraticInverse ||
                kernel == Kernel::InverseSquaredDistance || kernel == Kernel::Step)
    return weight(hn::Mul(squared, inverse_squared));
  else // neighbors lie within the radius, up to rounding
    return hn::Max(weight.ofRoot(hn::Min(hn::Mul(distance, inverse), constant(1))),
                   hn::Zero(F()));
}

template <Kernel kernel>
void
pairWeights(const Weighting& weighting,
            const float* squared,
            const float* distance,
            float inverse_radius,
            std::size_t count,
            float* weight)
{
  const F f;
  const ClampedWeight<kernel> w(weighting);
  const V inverse = constant(inverse_radius),
          inverse_squared = constant(inverse_radius * inverse_radius);
  for (std::size_t i = 0; i < count; i += hn::Lanes(f))
    hn::Store(weightAt<ClampedWeight<kernel>, kernel>(w,
                                                      hn::Load(f, squared + i),
                                                      hn::Load(f, distance + i),
                                                      inverse,
                                                      inverse_squared),
              f,
              weight + i);
}

template <Kernel kernel>
PairWeights
pairWeightsOf(const ClampedWeight<kernel>&)
{
  return pairWeights<kernel>;
}

/** \brief Weights of the pairs of buffers, all of them neighbors. */
class PairWeighting {
public:
  explicit PairWeighting(const SweepWeight& weight)
      : weight_(weight), tabled_(withTableOnly(weight, 1, [](const auto&) {}))
  {
    withWeight(weight.weighting,
               [&](const auto& w) HWY_ATTR { direct_ = pairWeightsOf(w); });
  }

  /** \brief Whether distances are needed, or only their squares. */
  bool
  needsDistances() const
  {
    return !tabled_;
  }

  /** \param[in] least no squared distance is smaller */
  void
  fill(const PairBuffer& squared,
       const PairBuffer& distance,
       float least,
       float inverse_radius,
       std::size_t count,
       PairBuffer& weights) const
  {
    const F f;
    const float scale = inverse_radius * inverse_radius;
    const bool far = least * scale >= weight_.table.from;
    if (!withTableOnly(weight_, scale, [&](const auto& w) HWY_ATTR {
          if (far)
            for (std::size_t i = 0; i < count; i += hn::Lanes(f))
              hn::Store(w.far(hn::Load(f, squared.value + i)), f, weights.value + i);
          else
            for (std::size_t i = 0; i < count; i += hn::Lanes(f))
              hn::Store(w(hn::Load(f, squared.value + i)), f, weights.value + i);
        }))
      direct_(weight_.weighting,
              squared.value,
              distance.value,
              inverse_radius,
              count,
              weights.value);
  }

private:
  const SweepWeight& weight_;
  bool tabled_;
  PairWeights direct_ = nullptr;
};

} // namespace HWY_NAMESPACE
} // namespace linelet::grid
HWY_AFTER_NAMESPACE();

#endif
