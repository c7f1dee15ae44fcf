// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

#ifdef _OPENMP
#include <omp.h>
#endif

#include <linelet/support/threads.h>

#include "support/parallel_failure.h"

namespace linelet {

/** \brief Calls \a work(begin, end) for chunks of 0, 1, ..., count - 1, on so many
 * \a threads, and throws what one of them throws.
 *
 * Inside a parallel region the chunks are tasks, in which those of its threads take
 * part that have nothing else to do. */
template <class Work>
void
forEachChunk(std::size_t count, std::size_t chunk, unsigned threads, const Work& work)
{
  const std::size_t chunks = (count + chunk - 1) / chunk;
  ParallelFailure failure;
  const auto run = [&](std::size_t k) {
    failure.guard([&] { work(k * chunk, std::min((k + 1) * chunk, count)); });
  };
#ifdef _OPENMP
  if (threadCount(threads) > 1 && omp_in_parallel() != 0) {
    const std::size_t helpers =
        std::min(chunks, static_cast<std::size_t>(omp_get_num_threads()));
    std::atomic<std::size_t> next{0};
    const auto drain = [&] {
      for (std::size_t k = next++; k < chunks; k = next++)
        run(k);
    };
#pragma omp taskgroup
    {
      for (std::size_t t = 1; t < helpers; ++t) {
#pragma omp task shared(drain)
        drain();
      }
      drain();
    }
    failure.rethrow();
    return;
  }
#endif
#pragma omp parallel for schedule(dynamic)                                             \
    num_threads(threadCount(threads)) if (chunks > 1)
  for (std::size_t k = 0; k < chunks; ++k)
    run(k);
  failure.rethrow();
}

} // namespace linelet
