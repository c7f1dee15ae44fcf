// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>

#include "block_sweep.h"

namespace linelet::grid {

PointDistributionTensor
BlockSweep::inDouble(std::size_t query, const PointList& candidates)
{
  // In the order of Engine::Tree, so that even the rounding is the same.
  exact_.clear();
  for (std::size_t i = 0; i < candidates.size; ++i)
    if (isNeighbour(query, candidates.id[i]))
      exact_.emplace_back(job_.surface.index(candidates.id[i]), candidates.id[i]);
  if (exact_.empty())
    return unknownTensor(0);
  std::sort(exact_.begin(), exact_.end());
  offsets_.clear();
  const Point at = job_.queries.point(first_ + query);
  for (const auto& neighbour : exact_)
    offsets_.push_back(job_.surface.point(neighbour.second) - at);
  return tensorOf(offsets_, radii_[query] * job_.radius, job_.settings);
}

void
BlockSweep::write()
{
  const std::size_t count = queries_.size();
  EigenBatch batch{};
  batch.count = count;
  for (std::size_t entry = 0; entry < 6; ++entry)
    batch.tensor[entry] = tensors_[entry].data();
  for (std::vector<double>& entries : eigen_)
    if (entries.size() < count + PointList::padding)
      entries.resize(count + PointList::padding);
  for (std::size_t i = 0; i < 3; ++i) {
    batch.values[i] = eigen_[i].data();
    batch.major[i] = eigen_[3 + i].data();
    batch.normal[i] = eigen_[6 + i].data();
  }
  kernels_.eigen(batch);

  const double area = job_.radius * job_.radius;
  const auto f = [](double value) { return static_cast<float>(value); };
  for (std::size_t i = 0; i < count; ++i) {
    if (!known_[i])
      continue;
    PointDistributionTensor& record = job_.records[job_.queries.index(first_ + i)];
    const double l1 = eigen_[0][i], l2 = eigen_[1][i], l3 = eigen_[2][i];
    const double inverse = 1 / (l1 + l2 + l3);
    record = {f(tensors_[0][i] * area),
              f(tensors_[1][i] * area),
              f(tensors_[2][i] * area),
              f(tensors_[3][i] * area),
              f(tensors_[4][i] * area),
              f(tensors_[5][i] * area),
              f(l1 * area),
              f(l2 * area),
              f(l3 * area),
              f(eigen_[3][i]),
              f(eigen_[4][i]),
              f(eigen_[5][i]),
              f(eigen_[6][i]),
              f(eigen_[7][i]),
              f(eigen_[8][i]),
              f((l3 - l2) * inverse),
              f(2 * (l2 - l1) * inverse),
              f(3 * l1 * inverse),
              found_[i]};
  }
}

} // namespace linelet::grid
