// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <linelet/opencl/screen_normal_engine.h>

#include "screen/depth_camera.h"

using namespace linelet;
using namespace linelet::test;

namespace {

TEST(OpenCLScreenNormals, AreThoseOfTheProcessor)
{
  if (opencl::devices().empty())
    GTEST_SKIP() << "no OpenCL device was found";
  opencl::ScreenNormalEngine engine;
  const Surface ball = [](const Point& ray) {
    return sphere(ray, Point(0.3, -0.2, 6), 2.2);
  };
  const Eigen::Vector3f eye = Eigen::Vector3f::Zero();
  for (const int layers : {1, 8}) {
    const DepthPicture picture(101, 77, layers, ball, 0.01, 3);
    for (const ScreenNormalMethod method : {ScreenNormalMethod::LocalDerivatives,
                                            ScreenNormalMethod::PlaneDiagonals,
                                            ScreenNormalMethod::PlaneCircle,
                                            ScreenNormalMethod::Tensor})
      for (const unsigned samples : {5U, 25U})
        for (const double limit : {0., 0.2}) {
          SCOPED_TRACE(std::string(nameOf(method)) + " " + std::to_string(samples));
          ScreenNormalSettings settings = normalsBy(method, samples);
          settings.max_distance = limit;
          settings.smoothing = samples == 25 ? 1 : 0;
          const NormalImage a = engine.estimate(picture.samples, eye, settings);
          const NormalImage b = screenNormals(picture.samples, eye, settings);
          std::size_t known = 0;
          for (std::size_t k = 0; k < a.x.size(); ++k) {
            ASSERT_EQ(std::isnan(a.x[k]), std::isnan(b.x[k]));
            if (std::isnan(a.x[k]))
              continue;
            ++known;
            ASSERT_NEAR(a.x[k], b.x[k], 1e-5);
            ASSERT_NEAR(a.y[k], b.y[k], 1e-5);
            ASSERT_NEAR(a.z[k], b.z[k], 1e-5);
          }
          EXPECT_GT(known, 1000u);
        }
  }
}

} // namespace
