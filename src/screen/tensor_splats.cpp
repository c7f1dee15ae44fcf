// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/screen/tensor_splats.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include <linelet/support/threads.h>

#include "glyph_footprint.h"

namespace linelet {

namespace {

/** \brief A splat ready to be drawn. */
struct Splat {
  float x, y;           // middle, pixels
  float xx, xy, yy;     // inverse of the ellipse: d' M d = 1 at the border
  float wave_x, wave_y; // phase of the stripes per pixel
  float width, height;  // half of the box around it
  float alpha, striped; // in the middle; part of the stripes
  std::array<float, 3> color;
};

/** \brief exp(-q / (2 s^2)), s = 0.4 of the splat, less what is left at its border, by
 * squared distance from the middle. */
class Falloff {
public:
  Falloff()
  {
    constexpr double width = 0.4;
    const double rest = std::exp(-0.5 / (width * width));
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const double q = static_cast<double>(i) / static_cast<double>(values_.size() - 2);
      values_[i] = static_cast<float>(
          std::max(0.0, (std::exp(-q / (2 * width * width)) - rest) / (1 - rest)));
    }
  }

  float
  operator()(float q) const
  {
    const float place = q * static_cast<float>(values_.size() - 2);
    const auto i = static_cast<std::size_t>(place);
    const float part = place - static_cast<float>(i);
    return values_[i] + part * (values_[i + 1] - values_[i]);
  }

private:
  std::array<float, 514> values_{};
};

/** \brief (1 + cos(2 M_PI t)) / 2. */
class Wave {
public:
  Wave()
  {
    for (std::size_t i = 0; i < values_.size(); ++i)
      values_[i] = static_cast<float>(
          0.5 + 0.5 * std::cos(2 * M_PI * static_cast<double>(i) /
                               static_cast<double>(values_.size() - 1)));
  }

  float
  operator()(float t) const
  {
    const float part = t - std::floor(t);
    return values_[static_cast<std::size_t>(part *
                                            static_cast<float>(values_.size() - 1))];
  }

private:
  std::array<float, 1025> values_{};
};

Splat
splatOf(const TensorGlyph& glyph,
        const screen::Footprint& print,
        const SplatSettings& settings)
{
  const Eigen::Vector2d along = print.axes.col(2).head<2>();
  Eigen::Vector2d across = print.axes.col(1).head<2>();
  const double length = print.axes.col(2).norm();
  const double width = print.axes.col(1).norm();
  // A disc seen edge-on still has a minimum width.
  const double least = std::max(settings.narrowest * length, 0.7);
  if (width > 0 && width < least)
    across *= least / width;
  Eigen::Matrix2d shape = along * along.transpose() + across * across.transpose();
  shape +=
      Eigen::Matrix2d::Identity() *
      std::max(0.49, 0.25 * settings.narrowest * settings.narrowest * length * length);
  // Stripes run along the projection of e3 itself, and so does what carries them.
  Eigen::Vector2d ahead = along;
  ahead =
      ahead.norm() > 0 ? Eigen::Vector2d(ahead.normalized()) : Eigen::Vector2d(0, 1);
  const Eigen::Vector2d normal(-ahead.y(), ahead.x());
  const double reach = std::sqrt(normal.dot(shape * normal));
  const double striped = std::clamp(1 - glyph.shape.planarity, 0.0, 1.0);
  shape = (1 - striped) * shape +
          striped * (ahead.dot(shape * ahead) * ahead * ahead.transpose() +
                     reach * reach * normal * normal.transpose());
  const Eigen::Matrix2d inverse = shape.inverse();
  const Eigen::Vector2d wave = normal * (settings.stripes / reach);
  const auto f = [](double value) { return static_cast<float>(value); };
  return {f(print.at.x()),
          f(print.at.y()),
          f(inverse(0, 0)),
          f(inverse(0, 1)),
          f(inverse(1, 1)),
          f(wave.x()),
          f(wave.y()),
          f(std::sqrt(shape(0, 0))),
          f(std::sqrt(shape(1, 1))),
          f(opacity(glyph.shape, settings)),
          f(striped),
          glyph.color};
}

/** \brief Blends a splat over the rows from \a begin to \a end. */
void
blend(const Splat& splat, int begin, int end, GlyphImage& image)
{
  static const Falloff falloff;
  static const Wave wave;
  const screen::PixelBox box(
      splat.x, splat.y, splat.width, splat.height, image.width, end);
  for (int y = std::max(box.top, begin); y <= box.bottom; ++y) {
    const float dy = static_cast<float>(y) + 0.5F - splat.y;
    for (int x = box.left; x <= box.right; ++x) {
      const float dx = static_cast<float>(x) + 0.5F - splat.x;
      const float q = splat.xx * dx * dx + 2 * splat.xy * dx * dy + splat.yy * dy * dy;
      if (!(q < 1))
        continue;
      const float stripes = wave(splat.wave_x * dx + splat.wave_y * dy);
      const float alpha =
          splat.alpha * falloff(q) * (1 - splat.striped * (1 - stripes));
      std::array<float, 4>& pixel = image.at(x, y);
      for (std::size_t c = 0; c < 3; ++c)
        pixel[c] += alpha * (splat.color[c] - pixel[c]);
      pixel[3] += alpha * (1 - pixel[3]);
    }
  }
}

/** \brief Back to front. Ties are broken by all other members, so that the order of the
 * input does not matter. */
std::vector<std::size_t>
drawingOrder(const std::vector<TensorGlyph>& glyphs,
             const std::vector<screen::Footprint>& prints)
{
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < glyphs.size(); ++i)
    if (prints[i].seen)
      order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (prints[a].at.z() != prints[b].at.z())
      return prints[a].at.z() > prints[b].at.z();
    for (Eigen::Index k = 0; k < 3; ++k)
      if (glyphs[a].center[k] != glyphs[b].center[k])
        return glyphs[a].center[k] < glyphs[b].center[k];
    for (Eigen::Index k = 0; k < 9; ++k)
      if (prints[a].axes.data()[k] != prints[b].axes.data()[k])
        return prints[a].axes.data()[k] < prints[b].axes.data()[k];
    return glyphs[a].color < glyphs[b].color;
  });
  return order;
}

} // namespace

double
opacity(const ShapeFactors& shape, const SplatSettings& settings)
{
  return std::pow(std::clamp(1 - shape.sphericity, 0.0, 1.0), settings.fade);
}

GlyphImage
drawSplats(const std::vector<TensorGlyph>& glyphs,
           const Camera& camera,
           const SplatSettings& settings)
{
  GlyphImage image;
  image.width = camera.width;
  image.height = camera.height;
  image.pixels.resize(static_cast<std::size_t>(camera.width) *
                      static_cast<std::size_t>(camera.height));
  std::vector<screen::Footprint> prints;
  prints.reserve(glyphs.size());
  for (const TensorGlyph& glyph : glyphs)
    prints.emplace_back(glyph, camera);
  std::vector<Splat> splats;
  for (const std::size_t i : drawingOrder(glyphs, prints)) {
    splats.push_back(splatOf(glyphs[i], prints[i], settings));
    constexpr float invisible = 1e-4F;
    if (!(splats.back().alpha > invisible) || !std::isfinite(splats.back().xx))
      splats.pop_back();
  }
  const int threads = threadCount(settings.threads);
  // Each band of rows is drawn by one thread; more bands than threads balance the
  // load.
  const int bands = std::min(4 * threads, std::max(1, camera.height));
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1)
  for (int band = 0; band < bands; ++band) {
    const auto row = [&](int number) {
      return static_cast<int>(std::int64_t{camera.height} * number / bands);
    };
    for (const Splat& splat : splats)
      if (splat.y + splat.height > static_cast<float>(row(band)) &&
          splat.y - splat.height < static_cast<float>(row(band + 1)))
        blend(splat, row(band), row(band + 1), image);
  }
  return image;
}

} // namespace linelet
