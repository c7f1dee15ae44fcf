// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/clustering/clusters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace linelet {

std::vector<double>
clusterMeans(const Clusters& clusters, const std::vector<double>& values)
{
  const std::size_t count = clusters.representatives.size();
  // Relative to the first value, so that large numbers such as times keep their digits.
  std::vector<double> first(count, std::nan("")), sums(count);
  std::vector<std::size_t> numbers(count);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Index cluster = clusters.cluster_of[i];
    if (cluster == Clusters::none || std::isnan(values[i]))
      continue;
    if (numbers[cluster]++ == 0)
      first[cluster] = values[i];
    sums[cluster] += values[i] - first[cluster];
  }
  for (std::size_t k = 0; k < count; ++k)
    if (numbers[k] > 0)
      first[k] += sums[k] / static_cast<double>(numbers[k]);
  return first;
}

std::vector<double>
clusterModes(const Clusters& clusters, const std::vector<double>& values)
{
  std::vector<std::pair<Index, double>> members;
  members.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (clusters.cluster_of[i] != Clusters::none && !std::isnan(values[i]))
      members.emplace_back(clusters.cluster_of[i], values[i]);
  std::sort(members.begin(), members.end());
  std::vector<double> modes(clusters.representatives.size(), std::nan(""));
  std::vector<std::size_t> most(modes.size());
  for (auto begin = members.begin(); begin != members.end();) {
    const auto end = std::find_if(
        begin, members.end(), [&](const auto& member) { return member != *begin; });
    const auto number = static_cast<std::size_t>(end - begin);
    if (number > most[begin->first]) {
      most[begin->first] = number;
      modes[begin->first] = begin->second;
    }
    begin = end;
  }
  return modes;
}

} // namespace linelet
