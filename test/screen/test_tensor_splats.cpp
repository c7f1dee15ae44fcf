// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <numeric>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <linelet/features/tensor_estimation.h>
#include <linelet/screen/tensor_splats.h>

using namespace linelet;

namespace {

using Colors = std::array<std::array<double, 3>, 3>;
const Colors pure = {{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}};

class Splats : public testing::Test {
protected:
  double
  uniform(double low, double high)
  {
    return boost::random::uniform_real_distribution<double>(low, high)(random_);
  }

  Point
  direction()
  {
    Point v;
    do
      v = Point(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
    while (!(v.norm() < 1 && v.norm() > 0.1));
    return v.normalized();
  }

  /** \brief A tensor with the given eigenvalues and a random rotation. */
  TensorGlyph
  glyph(const Point& center, double l1, double l2, double l3, double size)
  {
    const Point a = direction(), b = a.cross(direction()).normalized();
    SymmetricTensor t;
    t.add(l3, a);
    t.add(l2, b);
    t.add(l1, a.cross(b));
    const EigenSystem system = eigenAnalysis(t);
    return glyphOf(center, system, shapeFactors(system.values), size, pure);
  }

  std::vector<TensorGlyph>
  some(std::size_t count)
  {
    std::vector<TensorGlyph> glyphs;
    while (glyphs.size() < count)
      glyphs.push_back(glyph(Point(uniform(-2, 2), uniform(-2, 2), uniform(-2, 2)),
                             uniform(0, 0.4),
                             uniform(0.4, 0.7),
                             1,
                             uniform(0.1, 0.8)));
    return glyphs;
  }

  static Camera
  camera(int width = 160, int height = 120)
  {
    Camera camera;
    camera.lookAt(Point(-8, -6, 5), Point(0, 0, 0));
    camera.width = width;
    camera.height = height;
    camera.field_of_view = 40;
    return camera;
  }

  boost::random::mt19937 random_{17};
};

TEST_F(Splats, AreInvisibleInsideAFilledCuboid)
{
  // As published: extent 1, radius .2, about a hundred neighbors.
  Points points;
  while (points.size() < 20000)
    points.emplace_back(uniform(0, 1), uniform(0, 1), uniform(0, 1));
  TensorSettings settings;
  settings.radius = 0.2;
  settings.weighting = Kernel::Const;
  const auto records = estimateTensors(points, points, settings);
  double inside = 0, face = 0;
  std::size_t inner = 0, outer = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double border = std::min(points[i].minCoeff(), 1 - points[i].maxCoeff());
    const double alpha = opacity({static_cast<double>(records[i].linearity),
                                  static_cast<double>(records[i].planarity),
                                  static_cast<double>(records[i].sphericity)},
                                 SplatSettings());
    if (border > 0.2) {
      inside = std::max(inside, alpha);
      ++inner;
    }
    if (border < 0.01) {
      face += alpha;
      ++outer;
    }
  }
  EXPECT_GT(inner, 3000u);
  EXPECT_LT(inside, 0.01);
  EXPECT_GT(face / static_cast<double>(outer), 0.02);
}

TEST_F(Splats, StripesRunAlongTheProjectionOfTheMajorDirection)
{
  // Large, so that the pixels' own directions do not matter.
  const Camera view = camera(800, 800);
  for (int i = 0; i < 50; ++i) {
    // A line with noise around it.
    const TensorGlyph one = glyph(Point::Zero(), 0.01, 0.01, 1, 2);
    const Point from = view.project(Point::Zero());
    const Point to = view.project(one.axes.col(2) * 0.01);
    const Eigen::Vector2d wanted = (to - from).head<2>();
    if (wanted.norm() < 0.02 * 0.01 * view.focalLength())
      continue; // facing the eye
    const GlyphImage image = drawSplats({one}, view);
    Eigen::Matrix2d structure = Eigen::Matrix2d::Zero();
    for (int y = 1; y < image.height - 1; ++y)
      for (int x = 1; x < image.width - 1; ++x) {
        const Eigen::Vector2d slope(
            static_cast<double>(image.at(x + 1, y)[3] - image.at(x - 1, y)[3]),
            static_cast<double>(image.at(x, y + 1)[3] - image.at(x, y - 1)[3]));
        structure += slope * slope.transpose();
      }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(structure);
    const Eigen::Vector2d along = solver.eigenvectors().col(0);
    const double sine =
        std::abs(along.x() * wanted.y() - along.y() * wanted.x()) / wanted.norm();
    EXPECT_LT(std::asin(std::min(1.0, sine)) * 180 / M_PI, 2) << i;
  }
}

TEST_F(Splats, AreTheSamePictureInAnyOrderAndForAnyThreads)
{
  std::vector<TensorGlyph> glyphs = some(400);
  glyphs.insert(glyphs.end(), glyphs.begin(), glyphs.begin() + 50); // copies
  for (std::size_t i = 0; i < 50; ++i) { // others at the same place
    TensorGlyph other = glyph(glyphs[i].center, 0, 0.2, 1, 0.3);
    glyphs.push_back(other);
  }
  SplatSettings settings;
  settings.threads = 1;
  const GlyphImage first = drawSplats(glyphs, camera(), settings);
  for (std::size_t i = glyphs.size() - 1; i > 0; --i)
    std::swap(glyphs[i], glyphs[random_() % (i + 1)]);
  settings.threads = 3;
  EXPECT_EQ(drawSplats(glyphs, camera(), settings).pixels, first.pixels);
  EXPECT_EQ(drawEllipsoids(glyphs, camera(), 3).pixels.size(), first.pixels.size());
}

TEST_F(Splats, AreBlendedFromBackToFront)
{
  std::vector<TensorGlyph> glyphs = some(100);
  const Camera view = camera();
  const GlyphImage together = drawSplats(glyphs, view);
  std::sort(glyphs.begin(), glyphs.end(), [&](const auto& a, const auto& b) {
    return view.project(a.center).z() > view.project(b.center).z();
  });
  std::vector<std::array<double, 4>> expected(together.pixels.size());
  for (const TensorGlyph& one : glyphs) {
    const GlyphImage alone = drawSplats({one}, view);
    for (std::size_t k = 0; k < expected.size(); ++k)
      for (std::size_t c = 0; c < 4; ++c)
        expected[k][c] = static_cast<double>(alone.pixels[k][c]) +
                         (1 - static_cast<double>(alone.pixels[k][3])) * expected[k][c];
  }
  for (std::size_t k = 0; k < expected.size(); ++k)
    for (std::size_t c = 0; c < 4; ++c)
      ASSERT_NEAR(together.pixels[k][c], expected[k][c], 1e-5);
}

TEST_F(Splats, TakeTheirColorsFromTheShape)
{
  const auto needle = glyph(Point::Zero(), 0, 0, 1, 1).color;
  EXPECT_NEAR(needle[1], 1, 1e-6);
  const auto disc = glyph(Point::Zero(), 0, 1, 1, 1).color;
  EXPECT_NEAR(disc[0], 1, 1e-6);
  const auto ball = glyph(Point::Zero(), 1, 1, 1, 1).color;
  EXPECT_NEAR(ball[2], 1, 1e-6);
}

TEST_F(Splats, OfNothingOrNanAreAnEmptyPicture)
{
  TensorGlyph broken = some(1).front();
  broken.center.x() = std::nan("");
  TensorGlyph endless = some(1).front();
  endless.half_lengths.setConstant(std::numeric_limits<double>::infinity());
  for (const auto& glyphs : {std::vector<TensorGlyph>{}, {broken, endless}})
    for (const GlyphImage& image :
         {drawSplats(glyphs, camera()), drawEllipsoids(glyphs, camera())})
      for (const auto& pixel : image.pixels)
        ASSERT_EQ(pixel, (std::array<float, 4>{}));
}

TEST_F(Splats, EllipsoidsAreAsLargeAsTheyAre)
{
  Camera view;
  view.field_of_view = 0;
  view.view_height = 10;
  view.width = 200;
  view.height = 200; // 20 pixels per unit
  view.eye = Point(0, 0, -10);
  TensorGlyph one;
  one.half_lengths = Eigen::Vector3d(1, 2, 3);
  one.color = {1, 1, 1};
  GlyphImage image = drawEllipsoids({one}, view);
  double area = 0;
  for (const auto& pixel : image.pixels)
    area += static_cast<double>(pixel[3]);
  EXPECT_NEAR(area, M_PI * 20 * 40, 40);
  // A disc behind it is visible around it; one through its middle cuts it.
  TensorGlyph behind = one;
  behind.half_lengths = Eigen::Vector3d(3, 3, 0);
  behind.color = {1, 0, 0};
  behind.center.z() = 4;
  image = drawEllipsoids({one, behind}, view);
  EXPECT_GT(image.at(100, 100)[1], 0.1F);
  EXPECT_EQ(image.at(150, 100)[1], 0.F);
  EXPECT_GT(image.at(150, 100)[0], 0.1F);
  behind.center.z() = -4;
  image = drawEllipsoids({one, behind}, view);
  EXPECT_EQ(image.at(100, 100)[1], 0.F);
}

} // namespace
