// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <linelet/clustering/cluster_points.h>
#include <linelet/screen/shaded_faces.h>
#include <linelet/search/scale_unit.h>

#include "pictures.h"
#include "tensor_view.h"

namespace linelet::apps {

namespace {

/** \brief The representative as a disc, twice as long as an evenly filled cell, so that
 * discs, which fade toward their border, merge. */
TensorGlyph
glyphOf(const Representative& of, SplatColors colors)
{
  const EigenSystem system = eigenAnalysis(of.tensor);
  const double half = 2 * std::sqrt(3 * system.values[2]);
  return linelet::glyphOf(
      of.center, system, shapeFactors(system.values), half, splatColors(colors));
}

} // namespace

Canvas
pictureOfCells(const io::Cloud& cloud,
               const PictureSettings& settings,
               const std::string& file,
               Frame& frame)
{
  ClusterSettings cells;
  cells.leaf = settings.cell_size > 0
                   ? settings.cell_size
                   : 8 * scaleUnit(cloud.points, 1024, 1, frame.threads);
  if (!(cells.leaf > 0))
    throw std::runtime_error(file + ": no size can be chosen for the cells; give "
                                    "--cell-size");
  cells.threads = frame.threads;
  const bool splats = settings.kind == PictureKind::CellSplats;
  const bool boxes = settings.kind == PictureKind::CellBoxes;
  if (!splats)
    cells.faces = boxes ? CellFaces::Boxes : CellFaces::Quads;
  if (boxes)
    cells.moves = 0; // so that cells are boxes
  const Clusters clusters = clusterPoints(cloud.points, cells, {}, &frame.monitor);
  frame.lap("cluster");
  std::vector<TensorGlyph> glyphs;
  std::vector<std::array<float, 3>> colors;
  for (const Representative& one : clusters.representatives) {
    const TensorGlyph glyph = glyphOf(one, settings.splat_colors);
    // One point, or coincident points, have no shape.
    const bool shaped = std::isfinite(glyph.color[0]);
    colors.push_back(shaped ? glyph.color : std::array<float, 3>{0.6F, 0.6F, 0.6F});
    if (shaped)
      glyphs.push_back(glyph);
  }
  frame.summary["cell_size"] = cells.leaf;
  frame.summary["representatives"] = clusters.representatives.size();
  frame.summary["faces"] = clusters.faces.size();
  SplatSettings look;
  look.threads = frame.threads;
  return tensorView(cloud, settings, !splats, [&](const Camera& camera) {
    return splats ? drawSplats(glyphs, camera, look)
                  : drawFaces(clusters.faces, colors, camera, frame.threads);
  });
}

} // namespace linelet::apps
