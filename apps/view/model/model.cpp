// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "model.h"

#include <chrono>
#include <thread>
#include <utility>

namespace linelet::view {

void
Model::open(const std::vector<std::string>& paths, const std::string& truth)
{
  auto result = std::make_shared<std::shared_ptr<const Scene>>();
  analysis_.start(
      [=, options = settings.read, classes = settings.classes](
          ProgressMonitor* monitor) {
        *result = openScene(paths, truth, options, classes, monitor);
      },
      [this, result] { adopt(*result); });
}

void
Model::adopt(std::shared_ptr<const Scene> scene)
{
  probe_.cancel();
  imager_.cancel();
  select(std::nullopt);
  scene_ = std::move(scene);
  results_ = {};
  computed_with_ = {};
  preview_.reset();
  graphs_.reset();
  image_.reset();
  known_radii_.reset();
  curve = scene_->curves.curves.empty() ? -1 : 0;
  wire_ = 0;
  reviews_.clear();
  changes_.scene = true;
  if (scene_->lines != nullptr)
    adoptLines(scene_->lines);
}

void
Model::setPreview(const std::optional<Box>& box)
{
  preview_ = box;
}

void
Model::cancel()
{
  analysis_.cancel();
  probe_.cancel();
  imager_.cancel();
}

bool
Model::busy() const
{
  return analysis_.busy() || probe_.busy() || imager_.busy();
}

Progress
Model::progress() const
{
  return analysis_.busy() ? analysis_.progress() : Progress();
}

Model::Changes
Model::poll()
{
  std::string error;
  for (Worker* worker : {&analysis_, &probe_, &imager_})
    if (worker->poll(error) && !error.empty())
      changes_.error = error;
  return std::exchange(changes_, {});
}

Model::Changes
Model::wait()
{
  Changes all;
  while (true) {
    const bool was_busy = busy();
    const Changes some = poll();
    all.scene = all.scene || some.scene;
    all.results = all.results || some.results;
    all.probe = all.probe || some.probe;
    all.image = all.image || some.image;
    if (!some.error.empty())
      all.error = some.error;
    if (!was_busy)
      return all;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

AnalysisSettings
Model::withPreview() const
{
  AnalysisSettings with = settings;
  if (preview_) {
    const Point low = preview_->low + scene_->cloud.shift,
                high = preview_->high + scene_->cloud.shift;
    with.read.bounds_3d = {low.x(), low.y(), low.z(), high.x(), high.y(), high.z()};
  }
  return with;
}

std::string
Model::config(Analysis analysis) const
{
  return withPreview().config(analysis);
}

std::string
Model::fingerprint(Analysis analysis) const
{
  return config(analysis);
}

bool
Model::stale(Analysis analysis) const
{
  const std::string& with = computed_with_[static_cast<std::size_t>(analysis)];
  return !with.empty() && with != fingerprint(analysis);
}

std::string
Model::commandLine(Analysis analysis) const
{
  static constexpr const char* outputs[] = {
      "tensor.las", "multiscale.las", "curves.gpkg", "powerlines"};
  std::vector<std::string> inputs = scene_->inputs;
  if (inputs.empty())
    inputs.emplace_back("INPUT");
  return withPreview().commandLine(
      analysis, inputs, outputs[static_cast<std::size_t>(analysis)]);
}

} // namespace linelet::view
