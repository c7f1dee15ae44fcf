// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_01.hpp>
#include <cairo.h>

#include "run_tool.h"

namespace linelet::test {
namespace {

using Rgb = std::array<int, 3>;

class Picture {
public:
  explicit Picture(const std::string& path)
      : image_(cairo_image_surface_create_from_png(path.c_str()), cairo_surface_destroy)
  {
    EXPECT_EQ(cairo_surface_status(image_.get()), CAIRO_STATUS_SUCCESS) << path;
  }

  int
  width() const
  {
    return cairo_image_surface_get_width(image_.get());
  }
  int
  height() const
  {
    return cairo_image_surface_get_height(image_.get());
  }

  /** \brief The pixel, counted from the upper left corner. */
  Rgb
  at(int x, int y) const
  {
    const unsigned char* data = cairo_image_surface_get_data(image_.get());
    std::uint32_t pixel = 0;
    std::memcpy(&pixel,
                data + y * cairo_image_surface_get_stride(image_.get()) + 4 * x,
                sizeof(pixel));
    return {static_cast<int>(pixel >> 16 & 0xFF),
            static_cast<int>(pixel >> 8 & 0xFF),
            static_cast<int>(pixel & 0xFF)};
  }

  /** \brief Number of pixels whose channels are all within \a tolerance of \a color. */
  int
  count(const Rgb& color, int tolerance) const
  {
    int found = 0;
    for (int y = 0; y < height(); ++y)
      for (int x = 0; x < width(); ++x) {
        const Rgb pixel = at(x, y);
        bool same = true;
        for (std::size_t i = 0; i < 3; ++i)
          same = same && std::abs(pixel[i] - color[i]) <= tolerance;
        found += same ? 1 : 0;
      }
    return found;
  }

private:
  std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> image_;
};

// The pure colors of the shapes, as documented.
constexpr Rgb gray = {214, 214, 214}, blue = {33, 84, 217}, green = {26, 158, 51};

class ImageCommand : public ToolTest {
protected:
  /** \brief Points that fill 10 x 10 x 10, flattened to lower dimensions. */
  std::string
  cloud(int dimensions) const
  {
    boost::random::mt19937 random(5);
    boost::random::uniform_01<double> unit;
    std::string text;
    const int points = dimensions == 3 ? 30000 : 4000; // balls need more
    for (int i = 0; i < points; ++i) {
      std::string line;
      for (int axis = 0; axis < 3; ++axis)
        line += std::to_string(axis < dimensions ? 10 * unit(random) : 5.0) +
                (axis < 2 ? " " : "\n");
      text += line;
    }
    return write("cloud.xyz", text);
  }

  /** \brief A profile through the middle, far from the border compared with its
   * radii. */
  Picture
  profile(const std::string& options = "") const
  {
    runWell("image " + path("cloud.xyz") + " " + path("profile.png") +
            " --probe 4,5,5,6,5,5 --radii 1,1.5,2 --centroid pdt --width 600 "
            "--height 400 " +
            options);
    return Picture(path("profile.png"));
  }
};

// If one of these failed, a reader would mistake one shape for another.
TEST_F(ImageCommand, AProfileThroughALineIsGray)
{
  cloud(1);
  const Picture picture = profile();
  EXPECT_EQ(picture.width(), 600);
  EXPECT_EQ(picture.height(), 400);
  EXPECT_GT(picture.count(gray, 3), 600 * 400 / 3);
  EXPECT_LT(picture.count(blue, 40) + picture.count(green, 40), 600 * 400 / 50);
}

TEST_F(ImageCommand, AProfileThroughAPlaneIsBlue)
{
  cloud(2);
  const Picture picture = profile();
  EXPECT_GT(picture.count(blue, 40), 600 * 400 / 3);
  EXPECT_LT(picture.count(green, 40), 600 * 400 / 50);
}

TEST_F(ImageCommand, AProfileThroughAVolumeIsGreen)
{
  cloud(3);
  const Picture picture = profile();
  EXPECT_GT(picture.count(green, 60), 600 * 400 / 3);
  EXPECT_LT(picture.count(blue, 40), 600 * 400 / 50);
}

TEST_F(ImageCommand, OtherColorsDiffer)
{
  cloud(2);
  const Picture picture = profile("--colors safe");
  EXPECT_GT(picture.count({41, 120, 214}, 40), 600 * 400 / 3);
}

TEST_F(ImageCommand, TheGraphsMarkTheChosenRadius)
{
  cloud(1);
  runWell("image " + path("cloud.xyz") + " " + path("graphs.png") +
          " --point 5,5,5 --centroid pdt --width 600 --height 400");
  const Picture picture(path("graphs.png"));
  constexpr Rgb mark = {204, 38, 26};
  EXPECT_GT(picture.count(mark, 12), 200); // a line down the plot, dots and text
}

TEST_F(ImageCommand, ACloudShowsTheColorOfAnAttribute)
{
  std::string text = "x,y,z,warmth\n";
  for (int x = 0; x < 60; ++x)
    for (int y = 0; y < 60; ++y)
      text += std::to_string(x) + "," + std::to_string(y) + ",0," +
              std::to_string(x < 30 ? 0 : 1) + "\n";
  const std::string input = write("cloud.csv", text);
  runWell("image " + input + " " + path("cloud.png") +
          " --color warmth --elevation 90 --azimuth 180 --point-size 9 --width 500 "
          "--height 500");
  const Picture picture(path("cloud.png"));
  constexpr Rgb low = {69, 0, 84}, high = {252, 232, 36};
  EXPECT_GT(picture.count(low, 12), 500 * 500 / 20);
  EXPECT_GT(picture.count(high, 12), 500 * 500 / 20);
}

TEST_F(ImageCommand, NormalsOfAPlaneFromAboveLookAtTheEye)
{
  cloud(2);
  const std::string start =
      "image " + path("cloud.xyz") + " " + path("normals.png") +
      " --width 400 --height 300 --elevation 90 --point-size 8 --color ";
  runWell(start + "normal");
  const Picture normals(path("normals.png"));
  EXPECT_GT(normals.count({128, 128, 255}, 3), 400 * 300 / 5);
  runWell(start + "shaded");
  const Picture shaded(path("normals.png"));
  const Rgb lit = shaded.at(200, 130);
  EXPECT_EQ(lit[0], lit[1]);
  EXPECT_EQ(lit[1], lit[2]);
  EXPECT_GT(shaded.count(lit, 3), 400 * 300 / 5);
}

TEST_F(ImageCommand, LightOnPointsIsByTheSmallestEigenvector)
{
  // A floor and a wall, seen from the south and from above.
  std::string text = "x,y,z\n";
  for (int i = 0; i < 60; ++i)
    for (int k = 0; k < 30; ++k) {
      text += std::to_string(i) + "," + std::to_string(k) + ",0\n";
      text += std::to_string(i) + ",30," + std::to_string(k) + "\n";
    }
  runWell("image " + write("room.csv", text) + " " + path("room.png") +
          " --width 400 --height 300 --azimuth 180 --elevation 30 --point-size 9 "
          "--tensor-radius 3 --color minor");
  const Picture picture(path("room.png"));
  // The formula of the light, from above the left shoulder at (-.5, -.6, -.62): the
  // floor's normal is (0, -cos 30, -sin 30), the wall's (0, sin 30, -cos 30).
  const double length = std::hypot(0.5, 0.6, 0.62);
  const auto gray = [&](double y, double z) {
    const double bright = 0.22 + 0.76 * std::max(0.0, (-0.6 * y - 0.62 * z) / length);
    const int value = static_cast<int>(std::lround(255 * bright));
    return Rgb{value, value, value};
  };
  EXPECT_GT(picture.count(gray(-std::sqrt(0.75), -0.5), 6), 400 * 300 / 20)
      << "floor, at a slant";
  EXPECT_GT(picture.count(gray(0.5, -std::sqrt(0.75)), 6), 400 * 300 / 12) << "wall";
}

TEST_F(ImageCommand, TensorsAreSplatsOrEllipsoidsInTheColorsOfTheirShape)
{
  cloud(2);
  const std::string start =
      "image " + path("cloud.xyz") + " " + path("tensors.png") +
      " --width 400 --height 300 --elevation 90 "
      "--tensor-radius 1 --tensor-size 0.4 --splat-colors classic "
      "--kind ";
  for (const char* kind : {"splats", "ellipsoids"}) {
    runWell(start + kind);
    const Picture picture(path("tensors.png"));
    int red = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) {
        const Rgb pixel = picture.at(x, y);
        red += pixel[0] > 2 * pixel[1] && pixel[0] > 2 * pixel[2] ? 1 : 0;
      }
    EXPECT_GT(red, 400 * 300 / 8) << kind;
  }
}

TEST_F(ImageCommand, CellsAreDrawnInTheColorsOfTheirShape)
{
  cloud(2);
  for (const char* kind : {"cell-splats", "cell-quads", "cell-boxes"}) {
    runWell("image " + path("cloud.xyz") + " " + path("cells.png") +
            " --width 400 --height 300 --elevation 90 --cell-size 2 "
            "--splat-colors classic --kind " +
            kind);
    const Picture picture(path("cells.png"));
    int red = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) {
        const Rgb pixel = picture.at(x, y);
        // The paper shows between splats.
        red += pixel[0] > 1.5 * pixel[1] && pixel[0] > 1.5 * pixel[2] ? 1 : 0;
      }
    EXPECT_GT(red, 400 * 300 / 8) << kind;
  }
}

} // namespace
} // namespace linelet::test
