// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/opencl/screen_normal_engine.h>

#include <cstddef>
#include <limits>
#include <vector>

#include <linelet/support/threads.h>

#include "context.h"
#include "launch.h"
#include "screen/normal_passes.h"

namespace linelet::opencl {

namespace {

/** \brief Picture of normals.cl. */
struct Picture {
  cl_int width, height, layers, stride, layer, margin;
  cl_int method, rings;
  cl_float limit;
};

Picture
pictureOf(const screen::PaddedSamples& samples, const ScreenNormalSettings& settings)
{
  const auto distance = static_cast<float>(settings.max_distance);
  return {samples.width,
          samples.height,
          samples.layers,
          static_cast<cl_int>(samples.stride),
          static_cast<cl_int>(samples.layer),
          screen::PaddedSamples::margin,
          static_cast<cl_int>(settings.method),
          screen::ringsOf(settings.samples),
          distance > 0 ? distance * distance : std::numeric_limits<float>::infinity()};
}

} // namespace

struct ScreenNormalEngine::State {
  explicit State(const std::string& device) : context(device) {}

  Context context;
};

ScreenNormalEngine::ScreenNormalEngine(const std::string& device)
    : state_(std::make_unique<State>(device))
{
}

ScreenNormalEngine::~ScreenNormalEngine() = default;
ScreenNormalEngine::ScreenNormalEngine(ScreenNormalEngine&&) noexcept = default;
ScreenNormalEngine&
ScreenNormalEngine::operator=(ScreenNormalEngine&&) noexcept = default;

const Device&
ScreenNormalEngine::device() const
{
  return state_->context.device();
}

NormalImage
ScreenNormalEngine::estimate(const SampleLayers& samples,
                             const Eigen::Vector3f& eye,
                             const ScreenNormalSettings& settings)
{
  validate(settings);
  const int threads = threadCount(settings.threads);
  const screen::PaddedSamples pixels =
      screen::padded(samples, settings.max_distance, threads);
  NormalImage image = screen::emptyImage(pixels);
  const std::size_t count = image.x.size();
  if (count == 0)
    return image;
  std::vector<float> normals(3 * count);
  Context& context = state_->context;
  try {
    const cl::Buffer out = context.buffer(normals.size() * sizeof(float));
    const cl::Buffer inputs[] = {
        upload(context, std::vector<Picture>{pictureOf(pixels, settings)}),
        upload(context, pixels.x),
        upload(context, pixels.y),
        upload(context, pixels.z),
        upload(context, pixels.cx),
        upload(context, pixels.cy),
        upload(context, pixels.cz)};
    cl::Kernel kernel = context.exactKernel("screenNormals");
    cl_uint number = 0;
    for (const cl::Buffer& input : inputs)
      kernel.setArg(number++, input);
    kernel.setArg(number, out);
    run(context, kernel, count);
    context.queue().enqueueReadBuffer(
        out, CL_TRUE, 0, normals.size() * sizeof(float), normals.data());
  }
  catch (const cl::Error& error) {
    throw explained(error, device().name);
  }
  for (std::size_t k = 0; k < count; ++k) {
    image.x[k] = normals[3 * k];
    image.y[k] = normals[3 * k + 1];
    image.z[k] = normals[3 * k + 2];
  }
  screen::turnToEye(pixels, eye, image, threads);
  screen::smooth(pixels, settings, image, threads);
  return image;
}

} // namespace linelet::opencl
