// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "plain_view.h"

#include <string>

#include <linelet/io/vector_file.h>

namespace linelet::apps {

CloudView
plainView(const io::Cloud& cloud, const PictureSettings& settings)
{
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
  return view;
}

} // namespace linelet::apps
