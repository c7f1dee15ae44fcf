// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "reproject.h"

#include <cmath>
#include <memory>

#include <ogr_spatialref.h>

#include <linelet/io/file_error.h>
#include <linelet/io/reference_system.h>

#include "complaints.h"
#include "reference.h"

namespace linelet::io {

bool
isSystem(const std::string& wkt)
{
  const Reference reference = parseReference(wkt);
  return reference != nullptr && reference->IsLocal() == 0;
}

std::vector<VectorLayer>
reprojected(const std::string& path,
            std::vector<VectorLayer> layers,
            const std::string& from,
            const std::string& to)
{
  const Complaints complaints;
  const auto fail = [&] {
    throw FileError(path + ": cannot be projected from " + referenceName(from) +
                    " to " + referenceName(to) + " (" + complaints.first() +
                    "); name another system");
  };
  const Reference source = parseReference(from), target = parseReference(to);
  if (source == nullptr)
    return layers; // there is no feature
  const std::unique_ptr<OGRCoordinateTransformation> transformation(
      OGRCreateCoordinateTransformation(source.get(), target.get()));
  if (transformation == nullptr)
    fail();
  const bool degrees = std::isnan(unitsOf(to).plan);
  const double meters = degrees ? unitsOf(from).height : 1;
  for (VectorLayer& layer : layers)
    for (VectorFeature& feature : layer.features)
      for (Point& vertex : feature.vertices) {
        if (transformation->Transform(1, &vertex.x(), &vertex.y()) == 0)
          fail();
        vertex.z() *= meters;
      }
  return layers;
}

} // namespace linelet::io
