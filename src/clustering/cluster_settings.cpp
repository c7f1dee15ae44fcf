// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/clustering/cluster_settings.h>

#include <cmath>
#include <stdexcept>

#include <linelet/support/text.h>

namespace linelet {

void
validate(const ClusterSettings& settings)
{
  const int said =
      !settings.cells.empty() + (settings.leaf != 0) + (settings.count > 0);
  if (said != 1)
    throw std::invalid_argument(
        said == 0 ? "no grid is given: set the number of cells along each axis, the "
                    "edge of a cell (leaf), or how many representatives are wanted"
                  : "more than one grid is given: set either cells, or leaf, or count");
  if (!settings.cells.empty()) {
    if (settings.cells.size() != 3)
      throw std::invalid_argument("cells must be three numbers X,Y,Z, not " +
                                  std::to_string(settings.cells.size()));
    constexpr double most = 1e9;
    for (const double number : settings.cells)
      if (!(number >= 1 && number <= most) || number != std::floor(number))
        throw std::invalid_argument("cells along an axis must be a whole number from 1 "
                                    "to 1e9, not " +
                                    textOf(number));
  }
  else if (settings.count == 0 &&
           (!(settings.leaf > 0) || !std::isfinite(settings.leaf)))
    throw std::invalid_argument("leaf " + textOf(settings.leaf) +
                                " is not a positive finite number");
  if (!(settings.border > 0 && settings.border <= 0.5))
    throw std::invalid_argument("border " + textOf(settings.border) +
                                " is not above 0 and at most 0.5");
  if (!settings.camera)
    return;
  if (settings.cells.empty())
    throw std::invalid_argument("the grid of a camera's view needs a number of cells "
                                "along each of its axes");
  const Camera& camera = *settings.camera;
  if (!(camera.field_of_view > 0 && camera.field_of_view < 180))
    throw std::invalid_argument("the camera's field of view " +
                                textOf(camera.field_of_view) +
                                " is not between 0 and 180 degrees");
  if (camera.width < 1 || camera.height < 1 || !camera.eye.allFinite() ||
      !camera.axes.allFinite())
    throw std::invalid_argument("the camera's position, direction or picture size "
                                "is invalid");
}

} // namespace linelet
