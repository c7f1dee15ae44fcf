// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <map>
#include <string>

#define CL_HPP_ENABLE_EXCEPTIONS
#define CL_HPP_TARGET_OPENCL_VERSION 120
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#include <CL/opencl.hpp>

#include <linelet/opencl/device.h>

namespace linelet::opencl {

/** \brief An OpenCL \a error as our own, in one sentence. */
Error
explained(const cl::Error& error, const std::string& device);

/** \brief A device with its context, queue, and the programs built for it so far. */
class Context {
public:
  /** \brief Opens a device: the first GPU, else the first device of any kind; or, if \a
   * wish is not empty, the first one with that number (as listed by \ref devices) or
   * with \a wish in its name.
   * \param[in] lanes see \ref lanes; 0: as many as the device prefers
   * \param[in] use_double false: uses no double precision even if the device has it
   * \throws Error listing the devices if there is no such device */
  explicit Context(const std::string& wish = {},
                   unsigned lanes = 0,
                   bool use_double = true);

  const Device&
  device() const
  {
    return device_;
  }

  const cl::Context&
  context() const
  {
    return context_;
  }

  const cl::CommandQueue&
  queue() const
  {
    return queue_;
  }

  /** \brief Number of neighbors that the tensor kernel processes at a time: 1, 4, 8
   * or 16. */
  unsigned
  lanes() const
  {
    return lanes_;
  }

  /** \brief A kernel of the program built with \a definitions (`-D...`); built once. */
  cl::Kernel
  kernel(const std::string& name, const std::string& definitions = {});

  /** \brief A kernel of the program that computes exactly as written: nothing is fused,
   * reordered or approximated. */
  cl::Kernel
  exactKernel(const std::string& name);

  /** \brief A buffer of \a bytes (at least one). */
  cl::Buffer
  buffer(std::size_t bytes) const;

private:
  const cl::Program&
  program(const std::string& definitions);
  const cl::Program&
  built(const std::string& key, const std::string& sources, const std::string& options);

  Device device_;
  unsigned lanes_ = 1;
  std::size_t number_ = 0; ///< of the device, among all
  cl::Device cl_device_;
  cl::Context context_;
  cl::CommandQueue queue_;
  std::map<std::string, cl::Program> programs_;
};

} // namespace linelet::opencl
