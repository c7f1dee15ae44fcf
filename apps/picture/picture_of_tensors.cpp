// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <stdexcept>

#include <linelet/features/tensor_estimation.h>
#include <linelet/search/scale_unit.h>

#include "given_tensors.h"
#include "pictures.h"
#include "tensor_view.h"

namespace linelet::apps {

namespace {

TensorGlyph
glyphOf(const Point& point,
        const SymmetricTensor& tensor,
        double size,
        SplatColors colors)
{
  const EigenSystem system = eigenAnalysis(tensor);
  return linelet::glyphOf(
      point, system, shapeFactors(system.values), size, splatColors(colors));
}

/** \brief The tensors of the points; the radius follows from \a unit if the settings
 * give none. */
std::vector<SymmetricTensor>
estimated(const Points& points,
          const PictureSettings& settings,
          double unit,
          Frame& frame)
{
  TensorSettings tensors;
  tensors.radius = settings.radius > 0 ? settings.radius : 4 * unit;
  tensors.weighting = Kernel::Const;
  tensors.threads = frame.threads;
  frame.summary["tensor_radius"] = tensors.radius;
  std::vector<SymmetricTensor> result;
  for (const PointDistributionTensor& r :
       estimateTensors(points, points, tensors, {}, &frame.monitor))
    result.push_back({r.xx, r.xy, r.xz, r.yy, r.yz, r.zz});
  return result;
}

} // namespace

Canvas
pictureOfTensors(const io::Cloud& cloud,
                 const PictureSettings& settings,
                 const std::string& file,
                 Frame& frame)
{
  const bool known = (settings.radius > 0 || settings.tensors) && settings.size > 0;
  const double unit = known ? 0 : scaleUnit(cloud.points, 1024, 1, frame.threads);
  const double size = settings.size > 0 ? settings.size : unit;
  if (!(size > 0) || !(settings.radius > 0 || settings.tensors || unit > 0))
    throw std::runtime_error(file + ": no size can be chosen for the tensors; give "
                                    "--tensor-radius and --tensor-size");
  const std::vector<SymmetricTensor> tensors =
      settings.tensors ? givenTensors(cloud, file)
                       : estimated(cloud.points, settings, unit, frame);
  std::vector<TensorGlyph> glyphs;
  for (std::size_t i = 0; i < tensors.size(); ++i)
    if (tensors[i].matrix().allFinite() && tensors[i].trace() > 0)
      glyphs.push_back(
          glyphOf(cloud.points[i], tensors[i], size, settings.splat_colors));
  frame.lap("tensors");
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
