// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "las_records.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <linelet/support/threads.h>

#include "io/source.h"
#include "support/parallel_failure.h"

namespace linelet::io {

void
forEachRecords(const LasFront& front,
               std::size_t count,
               const FileWork& target,
               const std::function<void(const std::string& records)>& put)
{
  const int threads = threadCount(target.threads);
  const std::size_t group = 8 * static_cast<std::size_t>(threads); // blocks at a time
  const std::size_t blocks = (count + block_points - 1) / block_points;
  std::vector<std::string> made, next;
  for (std::size_t begin = 0; begin < blocks || !made.empty(); begin += group) {
    next.clear();
    next.resize(begin < blocks ? std::min(group, blocks - begin) : 0);
    ParallelFailure failure;
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (std::size_t k = 0; k <= next.size(); ++k)
      failure.guard([&] {
        if (k == 0) {
          std::for_each(made.begin(), made.end(), put);
          return;
        }
        const std::size_t first = (begin + k - 1) * block_points;
        const std::size_t number = std::min(block_points, count - first);
        next[k - 1] = front.makeRecords(first, number);
        target.advance(number);
      });
    failure.rethrow();
    std::swap(made, next);
  }
}

} // namespace linelet::io
