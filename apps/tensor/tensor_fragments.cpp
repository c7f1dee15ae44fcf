// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <linelet/features/tensor_estimation.h>
#include <linelet/features/tensor_record.h>

#include "fragments/fragment_parts.h"
#include "tensor_job.h"
#include "tensor_tally.h"

namespace linelet::apps {

void
TensorJob::check()
{
  if (!isRadius(settings_.radius) || settings_.k > 0 || !fields_.radius.empty() ||
      !fields_.knn.empty())
    throw std::runtime_error(
        "fragments need --radius to know all neighbors; give it, or more --memory");
  validate(settings_, {}, 0);
  if (finder_.engine == EngineOption::Auto)
    finder_.engine = EngineOption::Grid; // what Auto chooses for clouds of any size
  checkPartsOutput(input_, output_);
}

double
TensorJob::ghost(const Figures& /*measures*/)
{
  return tensorMargin(settings_);
}

FragmentJob::Devices
TensorJob::devices()
{
  Devices all{{"processor"}, schedule_};
  if (finder_.engine != EngineOption::All)
    all.names = {""};
  else if (!std::exchange(listed_, true)) {
    devices_ = devicesNamed(finder_.device);
    if (devices_.empty())
      frame_.warn("there is no such OpenCL device; using only the processor");
  }
  for (const NamedDevice& device : devices_)
    all.names.push_back(device.name);
  engines_.resize(std::max<std::size_t>(1, devices_.size()));
  return all;
}

DeviceEngine&
TensorJob::openDevice(std::size_t device)
{
  const bool alone = finder_.engine == EngineOption::OpenCL;
  std::unique_ptr<DeviceEngine>& engine = engines_.at(alone ? 0 : device - 1);
  if (!engine)
    engine = std::make_unique<DeviceEngine>(alone ? finder_.device
                                                  : devices_.at(device - 1).number);
  return *engine;
}

/** The records of the points of \a piece. */
std::vector<PointDistributionTensor>
TensorJob::tensorsOf(const FragmentTask& task, const CloudPiece& piece)
{
  TensorSettings settings = settings_;
  settings.threads = frame_.threads; // of this worker
  settings.engine = finder_.onProcessor();
  const Points& points = task.fragment.points;
  if (finder_.takesPieces() && task.device == 0)
    return pieceTensors(points, piece, settings, {}, task.monitor);
  const Points queries(points.begin() + static_cast<std::ptrdiff_t>(piece.begin),
                       points.begin() + static_cast<std::ptrdiff_t>(piece.end));
  if (queries.empty())
    return {};
  if (isOfPcl(finder_.search))
    return tensorsWith(finder_, points, queries, settings, {}, frame_);
  DeviceEngine& engine = openDevice(task.device);
  auto records = engine.estimate(points, queries, settings, {}, task.monitor);
  if (finder_.engine == EngineOption::OpenCL)
    engine.summarize(frame_.summary);
  return records;
}

Figures
TensorJob::compute(const FragmentTask& task)
{
  const CloudPiece piece = pieceOf(task.plan, task.fragment);
  const std::vector<PointDistributionTensor> records = tensorsOf(task, piece);
  fragments::writeRecords(
      task.result, task.fragment, records.data(), sizeof(records[0]), piece.begin);
  return {};
}

Figures
TensorJob::write(const OutputTask& task)
{
  Tally total;
  const auto add = [&](io::Cloud& cloud,
                       const std::vector<PointDistributionTensor>& records,
                       std::size_t left_out) {
    total.add(tallyOf(records, left_out));
    addFeatures(cloud, records, features_);
  };
  writeParts<PointDistributionTensor>(
      task, input_, output_, unknownTensor(0), add, frame_);
  return {{"points", total.points},
          {"left_out", total.left_out},
          {"unknown", total.unknown},
          {"neighbors",
           total.mean_neighbors * static_cast<double>(total.points - total.left_out)}};
}

void
TensorJob::report(const Figures& figures)
{
  Tally total;
  total.points = static_cast<std::size_t>(figures.at("points"));
  total.left_out = static_cast<std::size_t>(figures.at("left_out"));
  total.unknown = static_cast<std::size_t>(figures.at("unknown"));
  if (total.points > total.left_out)
    total.mean_neighbors =
        figures.at("neighbors") / static_cast<double>(total.points - total.left_out);
  print(total, output_.path(), settings_, finder_, fields_);
  printUnknown(total);
  summarize(frame_.summary, total, settings_, finder_, fields_);
  frame_.summary["left_out"] = total.left_out;
}

} // namespace linelet::apps
