// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <stdexcept>

#include <linelet/features/tensor_estimation.h>
#include <linelet/search/scale_unit.h>

#include "pictures.h"
#include "tensor_view.h"

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

  SplatSettings splats;
  splats.threads = frame.threads;
  const bool ellipsoids = settings.kind == PictureKind::Ellipsoids;
  return tensorView(cloud, settings, ellipsoids, [&](const Camera& camera) {
    return ellipsoids ? drawEllipsoids(glyphs, camera, frame.threads)
                      : drawSplats(glyphs, camera, splats);
  });
}

} // namespace linelet::apps
