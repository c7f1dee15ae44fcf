// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#ifdef _OPENMP
#include <omp.h>
#endif

namespace linelet {

/** \brief Threads that a request for \a requested threads gets: itself, or for 0 what
 * OpenMP offers (OMP_NUM_THREADS is honoured). Never changes the process-wide count. */
inline int
threadCount([[maybe_unused]] unsigned requested)
{
#ifdef _OPENMP
  return requested == 0 ? omp_get_max_threads() : static_cast<int>(requested);
#else
  return 1;
#endif
}

} // namespace linelet
