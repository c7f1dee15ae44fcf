// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC opencl {

/** \brief A failure of OpenCL; what() names the step, the device and OpenCL's error by
 * name and code. */
class Error : public std::runtime_error {
public:
  Error(const std::string& message, int code) : std::runtime_error(message), code_(code)
  {
  }

  /** \brief OpenCL's error code, 0 if the failure is not OpenCL's. */
  int
  code() const
  {
    return code_;
  }

private:
  int code_;
};

/** \brief An OpenCL device of this machine. */
struct Device {
  std::string name;
  std::string platform;
  std::string version;      ///< OpenCL version as the device reports it
  std::string type;         ///< "cpu", "gpu" or "accelerator"
  std::uint64_t memory = 0; ///< global memory, bytes
  unsigned compute_units = 0;
  bool double_precision = false; ///< whether it supports double
};

/** \brief All devices of all platforms; empty if there are none. */
std::vector<Device>
devices();

} // namespace opencl
} // namespace linelet
