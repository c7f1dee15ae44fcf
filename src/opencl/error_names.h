// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>

namespace linelet::opencl {

/** \brief The name of an OpenCL error code, as in CL_OUT_OF_RESOURCES. */
const char*
errorName(std::int32_t code);

} // namespace linelet::opencl
