// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include <hwy/aligned_allocator.h>

#include <linelet/support/points.h>
#include <linelet/tensor/neighborhood_tensor.h>

namespace linelet::grid {

/** \brief Candidates for neighbors: coordinates in units of the radius, relative to a
 * point that the list's maker states. Aligned for vector loads and followed by padding
 * that no ball reaches. */
class PointList {
public:
  /** \brief Largest number of lanes of a vector of floats; as many entries after the
   * last one may be written. */
  static constexpr std::size_t padding = 64;

  /** \brief Coordinates of padding, and its squared distance from anywhere. */
  static constexpr float far_away = 1e15F, far_away_square = 1e30F;

  std::size_t size = 0;
  float *x = nullptr, *y = nullptr, *z = nullptr;
  float* h = nullptr;          ///< squared distance from the origin of the list
  std::uint32_t* id = nullptr; ///< sorted index of the point in its BlockOrder

  /** \brief Reserves \a count entries; the content is lost when it grows. */
  void
  reserve(std::size_t count)
  {
    if (x != nullptr && count <= capacity_)
      return;
    capacity_ = count + count / 4 + 256;
    const std::size_t stride = (capacity_ + 2 * padding) / padding * padding;
    floats_ = hwy::AllocateAligned<float>(4 * stride);
    ids_ = hwy::AllocateAligned<std::uint32_t>(stride);
    x = floats_.get();
    y = x + stride;
    z = y + stride;
    h = z + stride;
    id = ids_.get();
  }

  /** \brief Reserves \a more entries after the last one and keeps the content. */
  void
  extend(std::size_t more)
  {
    if (x != nullptr && size + more <= capacity_)
      return;
    PointList larger;
    larger.reserve(2 * (size + more));
    larger.size = size;
    if (x != nullptr) {
      std::memcpy(larger.x, x, size * sizeof(float));
      std::memcpy(larger.y, y, size * sizeof(float));
      std::memcpy(larger.z, z, size * sizeof(float));
      std::memcpy(larger.h, h, size * sizeof(float));
      std::memcpy(larger.id, id, size * sizeof(std::uint32_t));
    }
    *this = std::move(larger);
  }

  /** \brief Appends padding after the last entry. */
  void
  pad()
  {
    for (std::size_t i = size; i < size + padding; ++i) {
      x[i] = y[i] = z[i] = far_away;
      h[i] = far_away_square;
      id[i] = 0;
    }
  }

private:
  std::size_t capacity_ = 0;
  hwy::AlignedFreeUniquePtr<float[]> floats_;
  hwy::AlignedFreeUniquePtr<std::uint32_t[]> ids_;
};

/** \brief Sums over points p: number (or weight), p, and p (x) p. */
struct Moments : SymmetricTensor {
  double count = 0;
  Point first = Point::Zero();

  void
  add(double weight, const Point& p)
  {
    count += weight;
    first += weight * p;
    SymmetricTensor::add(weight, p);
  }

  Moments&
  operator+=(const Moments& other)
  {
    count += other.count;
    first += other.first;
    SymmetricTensor::operator+=(other);
    return *this;
  }

  /** \brief The same sums with weights \a factor times as large. */
  Moments
  times(double factor) const
  {
    Moments m = *this;
    m.count *= factor;
    m.first *= factor;
    m *= factor;
    return m;
  }

  /** \brief The same sums of p - \a origin. */
  Moments
  relativeTo(const Point& origin) const
  {
    const Point &o = origin, &s = first;
    Moments m = *this;
    m.first -= count * o;
    m.xx += o.x() * (count * o.x() - 2 * s.x());
    m.yy += o.y() * (count * o.y() - 2 * s.y());
    m.zz += o.z() * (count * o.z() - 2 * s.z());
    m.xy += count * o.x() * o.y() - s.x() * o.y() - s.y() * o.x();
    m.xz += count * o.x() * o.z() - s.x() * o.z() - s.z() * o.x();
    m.yz += count * o.y() * o.z() - s.y() * o.z() - s.z() * o.y();
    return m;
  }
};

} // namespace linelet::grid
