// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "model.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include <linelet/powerline/metric_frame.h>
#include <linelet/powerline_output/review_file.h>

namespace linelet::view {

const powerline::PowerLineNetwork*
Model::lines() const
{
  return results_.lines != nullptr ? results_.lines.get() : scene_->lines.get();
}

const CurveNetwork&
Model::curves() const
{
  return results_.curves != nullptr ? *results_.curves : scene_->curves;
}

Point
Model::toCloud(const Point& of_network) const
{
  return powerline::MetricFrame(scene_->cloud).world(of_network) - scene_->cloud.shift;
}

void
Model::adoptLines(std::shared_ptr<const powerline::PowerLineNetwork> lines)
{
  reviews_.clear();
  for (const powerline::Wire& wire : lines->wires)
    reviews_.push_back(wire.review);
  wire_ = 0;
  if (lines != scene_->lines || !std::filesystem::exists(reviewFile()))
    return;
  try {
    const auto saved = powerline::readReview(reviewFile(), scene_->cloud);
    const std::vector<int> matches = powerline::matchReviewed(*lines, saved);
    for (std::size_t i = 0; i < matches.size(); ++i)
      if (matches[i] >= 0)
        reviews_[i] = saved[static_cast<std::size_t>(matches[i])].review;
  }
  catch (const std::exception& error) {
    changes_.error = error.what();
  }
}

std::vector<powerline::ReviewedWire>
Model::reviewedWires() const
{
  std::vector<powerline::ReviewedWire> reviewed;
  for (std::size_t i = 0; lines() != nullptr && i < reviews_.size(); ++i)
    if (!reviews_[i].empty())
      reviewed.push_back({powerline::polyline(lines()->wires[i]), reviews_[i]});
  return reviewed;
}

std::vector<int>
Model::wiresByConfidence() const
{
  std::vector<int> ids;
  if (lines() == nullptr)
    return ids;
  for (const powerline::Wire& wire : lines()->wires)
    ids.push_back(wire.id);
  std::stable_sort(ids.begin(), ids.end(), [&](int a, int b) {
    const auto confidence = [&](int id) {
      return lines()->wires[static_cast<std::size_t>(id) - 1].confidence;
    };
    return confidence(a) < confidence(b);
  });
  return ids;
}

void
Model::selectWire(int id)
{
  if (id < 0 || static_cast<std::size_t>(id) > reviews_.size())
    throw std::invalid_argument("there is no wire " + std::to_string(id) +
                                "; there are " + std::to_string(reviews_.size()));
  wire_ = id;
  changes_.probe = true;
}

const powerline::Review&
Model::review(int id) const
{
  return reviews_.at(static_cast<std::size_t>(id) - 1);
}

std::string
Model::reviewFile() const
{
  namespace fs = std::filesystem;
  if (!scene_->folder.empty() && results_.lines == nullptr)
    return (fs::path(scene_->folder) / "reviewed.gpkg").string();
  if (scene_->inputs.empty())
    return "reviewed.gpkg";
  fs::path input(scene_->inputs.front());
  if (!input.has_filename())
    input = input.parent_path();
  return (input.parent_path() / (input.stem().string() + "_reviewed.gpkg")).string();
}

powerline::PowerLineNetwork
Model::reviewed() const
{
  powerline::PowerLineNetwork network;
  if (lines() != nullptr)
    network = *lines();
  for (std::size_t i = 0; i < reviews_.size(); ++i)
    network.wires[i].review = reviews_[i];
  return network;
}

void
Model::setReview(int id, const powerline::Review& review)
{
  if (id < 1 || static_cast<std::size_t>(id) > reviews_.size())
    throw std::invalid_argument("select a wire first");
  if (review.point_class > 255)
    throw std::invalid_argument("class " + std::to_string(review.point_class) +
                                " does not fit into a LAS file, whose classes are 0 "
                                "to 255");
  reviews_[static_cast<std::size_t>(id) - 1] = review;
  changes_.probe = true;
  powerline::OutputOptions options;
  options.clearance = settings.wires.clearance;
  powerline::writeReview(reviewFile(), scene_->cloud, reviewed(), options);
}

} // namespace linelet::view
