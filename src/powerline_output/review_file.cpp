// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/powerline_output/review_file.h>

#include <stdexcept>

#include <linelet/io/file_error.h>
#include <linelet/io/vector_file.h>
#include <linelet/powerline/metric_frame.h>

namespace linelet::powerline {

namespace {

const io::Value*
find(const io::Attributes& attributes, const char* name)
{
  for (const auto& [key, value] : attributes)
    if (key == name)
      return &value;
  return nullptr;
}

std::string
textOf(const io::Value* value)
{
  const auto* text = value == nullptr ? nullptr : std::get_if<std::string>(value);
  return text == nullptr ? std::string() : *text;
}

Review
reviewOf(const io::Attributes& attributes)
{
  Review review;
  review.verdict = fromName<Review::Verdict>(textOf(find(attributes, "review")));
  review.note = textOf(find(attributes, "review_note"));
  if (const io::Value* value = find(attributes, "review_class"))
    if (const auto* number = std::get_if<std::int64_t>(value)) {
      if (*number < -1 || *number > 255)
        throw std::invalid_argument("review_class " + std::to_string(*number) +
                                    " is neither -1 nor a class from 0 to 255");
      review.point_class = static_cast<int>(*number);
    }
  return review;
}

} // namespace

std::vector<ReviewedWire>
readReview(const std::string& path, const io::Cloud& cloud)
{
  const MetricFrame frame(cloud);
  std::vector<ReviewedWire> reviewed;
  for (const io::VectorLayer& layer : io::readLayers(path))
    for (const io::VectorFeature& feature : layer.features) {
      if (find(feature.attributes, "review") == nullptr)
        throw io::FileError(path + ": its lines have no column 'review'; name a file "
                                   "that linelet-view saved, or a wires.gpkg");
      ReviewedWire one;
      for (const Point& vertex : feature.vertices)
        one.vertices.push_back(frame.meters(vertex - cloud.shift));
      try {
        one.review = reviewOf(feature.attributes);
      }
      catch (const std::invalid_argument& error) {
        throw io::FileError(path + ": line " + std::to_string(reviewed.size() + 1) +
                            ": " + error.what());
      }
      reviewed.push_back(std::move(one));
    }
  return reviewed;
}

void
writeReview(const std::string& path,
            const io::Cloud& cloud,
            const PowerLineNetwork& network,
            const OutputOptions& options)
{
  // It is read back with the cloud, so in its coordinates, even as GeoJSON.
  const io::VectorOptions vectors{"", true};
  io::writeLayers(path,
                  powerLineLayers(cloud, network, options),
                  cloud.wkt,
                  nullptr,
                  nullptr,
                  vectors);
}

} // namespace linelet::powerline
