// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "context.h"

#include <algorithm>
#include <filesystem>

#include <linelet/tensor/centroid.h>
#include <linelet/tensor/weighting.h>

#include "error_names.h"
#include "kernel_sources.h"

namespace linelet::opencl {

namespace {

// The driver may reorder sums and fuse multiplications: results hold to float accuracy.
// Infinities and NaN keep their meaning: some weights pass through them.
constexpr const char* build_options =
    "-cl-std=CL1.2 -cl-mad-enable -cl-no-signed-zeros -cl-unsafe-math-optimizations ";

/** \brief The enumerators that kernels know by name, as macros. */
std::string
enumerators()
{
  std::string text;
  const auto define = [&](const char* name, auto value) {
    text += std::string("#define ") + name + ' ' +
            std::to_string(static_cast<int>(value)) + '\n';
  };
#define LINELET_KERNEL(kernel, name, support, weight)                                  \
  define("KERNEL_" #kernel, Kernel::kernel);
  LINELET_KERNELS(LINELET_KERNEL)
#undef LINELET_KERNEL
  define("CENTROID_QueryPoint", Centroid::QueryPoint);
  define("CENTROID_Mean", Centroid::Mean);
  define("CENTROID_WeightedMean", Centroid::WeightedMean);
  define("CENTROID_Median", Centroid::Median);
  return text;
}

Device
describe(const cl::Device& device)
{
  Device d;
  d.name = device.getInfo<CL_DEVICE_NAME>();
  d.platform =
      cl::Platform(device.getInfo<CL_DEVICE_PLATFORM>()).getInfo<CL_PLATFORM_NAME>();
  d.version = device.getInfo<CL_DEVICE_VERSION>();
  const cl_device_type type = device.getInfo<CL_DEVICE_TYPE>();
  d.type = (type & CL_DEVICE_TYPE_GPU) != 0   ? "gpu"
           : (type & CL_DEVICE_TYPE_CPU) != 0 ? "cpu"
                                              : "accelerator";
  d.memory = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
  d.compute_units = device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
  d.double_precision =
      device.getInfo<CL_DEVICE_EXTENSIONS>().find("cl_khr_fp64") != std::string::npos;
  return d;
}

std::vector<cl::Device>
allDevices()
{
  // Without sysfs (in a bare chroot, say) drivers find no hardware, and PoCL aborts the
  // process instead of reporting it.
  if (!std::filesystem::exists("/sys/devices"))
    return {};
  std::vector<cl::Platform> platforms;
  try {
    cl::Platform::get(&platforms);
  }
  catch (const cl::Error&) {
    return {}; // the loader found no driver
  }
  std::vector<cl::Device> all;
  for (const cl::Platform& platform : platforms) {
    std::vector<cl::Device> some;
    try {
      platform.getDevices(CL_DEVICE_TYPE_ALL, &some);
    }
    catch (const cl::Error&) {
      continue; // a platform without devices reports an error
    }
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

std::string
listing(const std::vector<cl::Device>& all)
{
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i)
    text += (i == 0 ? "" : ", ") + std::to_string(i) + ": " +
            all[i].getInfo<CL_DEVICE_NAME>();
  return text;
}

/** \return its place in \a all */
std::size_t
choose(const std::vector<cl::Device>& all, const std::string& wish)
{
  if (all.empty())
    throw Error(
        "no OpenCL device was found; install a driver (on Debian: apt-get install "
        "pocl-opencl-icd) or choose another engine",
        CL_DEVICE_NOT_FOUND);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (wish.empty() && describe(all[i]).type == "gpu")
      return i;
    if (!wish.empty() &&
        (wish == std::to_string(i) ||
         all[i].getInfo<CL_DEVICE_NAME>().find(wish) != std::string::npos))
      return i;
  }
  if (wish.empty())
    return 0;
  throw Error("OpenCL has no device '" + wish + "'; there is " + listing(all),
              CL_DEVICE_NOT_FOUND);
}

} // namespace

std::vector<Device>
devices()
{
  std::vector<Device> result;
  for (const cl::Device& device : allDevices())
    result.push_back(describe(device));
  return result;
}

Error
explained(const cl::Error& error, const std::string& device)
{
  return {std::string("OpenCL: ") + error.what() + " failed on device '" + device +
              "' with " + errorName(error.err()) + " (" + std::to_string(error.err()) +
              ")",
          error.err()};
}

Context::Context(const std::string& wish, unsigned lanes, bool use_double)
    : lanes_(lanes)
{
  const std::vector<cl::Device> all = allDevices();
  number_ = choose(all, wish);
  cl_device_ = all[number_];
  device_ = describe(cl_device_);
  device_.double_precision &= use_double;
  const auto native = cl_device_.getInfo<CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT>();
  if (lanes_ == 0)
    lanes_ = native >= 16 ? 16 : native >= 8 ? 8 : native >= 4 ? 4 : 1;
  try {
    context_ = cl::Context(cl_device_);
    queue_ = cl::CommandQueue(context_, cl_device_);
  }
  catch (const cl::Error& error) {
    throw explained(error, device_.name);
  }
}

const cl::Program&
Context::built(const std::string& key,
               const std::string& sources,
               const std::string& options)
{
  const auto known = programs_.find(key);
  if (known != programs_.end())
    return known->second;
  // PoCL 3.1 counts the users of a kernel by its preprocessed source, and aborts when
  // two devices run the same one at once: make sure that no two are the same.
  const std::string own = "typedef int device_" + std::to_string(number_) + ";\n";
  cl::Program program(context_, own + sources);
  try {
    program.build({cl_device_}, options.c_str());
  }
  catch (const cl::Error& error) {
    throw Error("OpenCL: the kernels do not build on device '" + device_.name + "' (" +
                    errorName(error.err()) + "); its compiler says: " +
                    program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(cl_device_),
                error.err());
  }
  return programs_.emplace(key, program).first->second;
}

const cl::Program&
Context::program(const std::string& definitions)
{
  return built(definitions,
               enumerators() + kernel_sources,
               build_options + std::string(device_.double_precision ? "-DEXACT " : "") +
                   "-DWIDTH=" + std::to_string(lanes_) + " " + definitions);
}

cl::Kernel
Context::exactKernel(const std::string& name)
{
  const std::string sources =
      std::string("#pragma OPENCL FP_CONTRACT OFF\n") + exact_kernel_sources;
  return {built("exact", sources, "-cl-std=CL1.2"), name.c_str()};
}

cl::Kernel
Context::kernel(const std::string& name, const std::string& definitions)
{
  return {program(definitions), name.c_str()};
}

cl::Buffer
Context::buffer(std::size_t bytes) const
{
  return {context_, CL_MEM_READ_WRITE, std::max<std::size_t>(bytes, 1)};
}

} // namespace linelet::opencl
