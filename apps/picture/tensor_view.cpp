// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tensor_view.h"

#include <string>
#include <utility>
#include <vector>

#include "axes.h"
#include "plain_view.h"

namespace linelet::apps {

Canvas
tensorView(const io::Cloud& cloud,
           const PictureSettings& settings,
           bool spherical,
           const DrawImage& draw)
{
  const CloudView view = plainView(cloud, settings);
  constexpr double legend_height = 58;
  Canvas canvas = drawImage(view,
                            draw,
                            static_cast<int>(settings.width),
                            static_cast<int>(settings.height),
                            legend_height);
  const auto pure = splatColors(settings.splat_colors);
  std::vector<std::pair<Color, std::string>> legend = {{pure[0], "linear"},
                                                       {pure[1], "planar"}};
  if (spherical)
    legend.emplace_back(pure[2], "spherical");
  drawLegend(canvas, {24, canvas.height() - 28.0}, legend);
  return canvas;
}

} // namespace linelet::apps
