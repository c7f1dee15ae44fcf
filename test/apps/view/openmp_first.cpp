// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The model computes in its own thread. Archer, which explains OpenMP to
// ThreadSanitizer, crashes (libomp 14) if such a thread is the first to use it.

namespace {

[[maybe_unused]] const bool openmp_runs = [] {
#pragma omp parallel
  {
#pragma omp barrier // not to be optimized away
  }
  return true;
}();

} // namespace
