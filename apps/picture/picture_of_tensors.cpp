// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <stdexcept>

#include <linelet/features/tensor_estimation.h>
#include <linelet/io/vector_file.h>
#include <linelet/search/scale_unit.h>

#include "axes.h"
#include "cloud_view.h"
#include "pictures.h"

namespace linelet::apps {

namespace {

std::vector<TensorGlyph>
glyphsOf(const Points& points,
         const std::vector<PointDistributionTensor>& records,
         double size,
         SplatColors colors)
{
  const auto d = [](float value) { return static_cast<double>(value); };
  std::vector<TensorGlyph> glyphs;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const PointDistributionTensor& r = records[i];
    if (std::isnan(r.linearity))
      continue;
    const SymmetricTensor tensor = {
        d(r.xx), d(r.xy), d(r.xz), d(r.yy), d(r.yz), d(r.zz)};
    glyphs.push_back(glyphOf(points[i],
                             eigenAnalysis(tensor),
                             {d(r.linearity), d(r.planarity), d(r.sphericity)},
                             size,
                             splatColors(colors)));
  }
  return glyphs;
}

} // namespace

Canvas
pictureOfTensors(const io::Cloud& cloud,
                 const PictureSettings& settings,
                 const std::string& file,
                 Frame& frame)
{
  const double unit = settings.radius > 0 && settings.size > 0
                          ? 0
                          : scaleUnit(cloud.points, 1024, 1, frame.threads);
  TensorSettings tensors;
  tensors.radius = settings.radius > 0 ? settings.radius : 4 * unit;
  tensors.weighting = Kernel::Const;
  tensors.threads = frame.threads;
  const double size = settings.size > 0 ? settings.size : unit;
  if (!(tensors.radius > 0) || !(size > 0))
    throw std::runtime_error(file + ": no size can be chosen for the tensors; give "
                                    "--tensor-radius and --tensor-size");
  const std::vector<TensorGlyph> glyphs =
      glyphsOf(cloud.points,
               estimateTensors(cloud.points, cloud.points, tensors, {}, &frame.monitor),
               size,
               settings.splat_colors);
  frame.lap("tensors");
  frame.summary["tensor_radius"] = tensors.radius;
  frame.summary["tensor_size"] = size;
  frame.summary["tensors"] = glyphs.size();

  CloudView view;
  view.points = cloud.points;
  view.title = settings.title;
  view.azimuth = settings.azimuth;
  view.elevation = settings.elevation;
  view.curve_width = settings.curve_width;
  if (cloud.wkt.find("metre") != std::string::npos)
    view.unit = "m";
  if (!settings.curves.empty())
    view.curves = io::readCurves(settings.curves, cloud.shift);
  SplatSettings splats;
  splats.threads = frame.threads;
  const bool ellipsoids = settings.kind == PictureKind::Ellipsoids;
  const auto draw = [&](const std::vector<TensorGlyph>& all, const Camera& camera) {
    return ellipsoids ? drawEllipsoids(all, camera, frame.threads)
                      : drawSplats(all, camera, splats);
  };
  constexpr double legend_height = 58;
  Canvas canvas = drawGlyphs(view,
                             glyphs,
                             draw,
                             static_cast<int>(settings.width),
                             static_cast<int>(settings.height),
                             legend_height);
  const auto pure = splatColors(settings.splat_colors);
  std::vector<std::pair<Color, std::string>> legend = {{pure[0], "linear"},
                                                       {pure[1], "planar"}};
  if (ellipsoids)
    legend.emplace_back(pure[2], "spherical");
  drawLegend(canvas, {24, canvas.height() - 28.0}, legend);
  return canvas;
}

} // namespace linelet::apps
