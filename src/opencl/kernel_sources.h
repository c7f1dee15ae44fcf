// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

namespace linelet::opencl {

/** \brief The text of all kernels, embedded at build time. */
extern const char* const kernel_sources;

/** \brief Those of kernels that compute exactly as written. */
extern const char* const exact_kernel_sources;

} // namespace linelet::opencl
