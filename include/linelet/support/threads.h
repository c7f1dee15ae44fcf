// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <algorithm>

#ifdef _OPENMP
#include <omp.h>

#include <linelet/support/visibility.h>
#endif

namespace LINELET_PUBLIC linelet {

/** \brief The number of threads to use for \a requested: as many as requested, at most
 * 8 per processor, or for 0 what OpenMP offers (OMP_NUM_THREADS is honored). More gain
 * nothing, and OpenMP aborts the program if it cannot create them. Never changes the
 * process-wide count. */
inline int
threadCount([[maybe_unused]] unsigned requested)
{
#ifdef _OPENMP
  if (requested == 0)
    return omp_get_max_threads();
  const auto most = 8 * static_cast<unsigned>(omp_get_num_procs());
  return static_cast<int>(std::min(requested, most));
#else
  return 1;
#endif
}

} // namespace linelet
