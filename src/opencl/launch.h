// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include "context.h"

namespace linelet::opencl {

/** \brief A copy of \a values on the device. */
template <class T, class Allocator>
cl::Buffer
upload(const Context& context, const std::vector<T, Allocator>& values)
{
  const std::size_t bytes = values.size() * sizeof(T);
  cl::Buffer buffer = context.buffer(bytes);
  if (bytes > 0)
    context.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, bytes, values.data());
  return buffer;
}

/** \brief Enqueues a kernel for at least \a items work-items, in whole groups. */
inline void
run(const Context& context,
    const cl::Kernel& kernel,
    std::size_t items,
    std::size_t group_size = 256)
{
  context.queue().enqueueNDRangeKernel(
      kernel,
      cl::NullRange,
      cl::NDRange((items + group_size - 1) / group_size * group_size),
      cl::NDRange(group_size));
}

/** \brief Sets the arguments of a kernel, the first at \a first. */
template <class... Arguments>
void
setArgumentsFrom(cl_uint first, cl::Kernel& kernel, const Arguments&... arguments)
{
  cl_uint number = first;
  (kernel.setArg(number++, arguments), ...);
}

template <class... Arguments>
void
setArguments(cl::Kernel& kernel, const Arguments&... arguments)
{
  setArgumentsFrom(0, kernel, arguments...);
}

} // namespace linelet::opencl
