// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <stdexcept>

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
        "fragments know the neighbors within --radius; give that, or more --memory");
  validate(settings_, {}, 0);
  if (finder_.engine == EngineOption::Auto)
    finder_.engine = EngineOption::Grid; // what it is for clouds of any size
  checkPartsOutput(input_, output_);
}

double
TensorJob::ghost(const std::map<std::string, double>& /*measures*/)
{
  return tensorMargin(settings_);
}

double
TensorJob::bytesPerPoint(bool in_fragments) const
{
  // Cloud, usable points, engine, records, and these as columns; or two fragments,
  // engine and records.
  return in_fragments ? 200 : 300;
}

std::map<std::string, double>
TensorJob::compute(const fragments::Plan& plan,
                   const fragments::Fragment& fragment,
                   const std::string& result,
                   ProgressMonitor* monitor)
{
  TensorSettings settings = settings_;
  settings.threads = frame_.threads; // of this worker
  settings.engine = finder_.onProcessor();
  const Points& points = fragment.points;
  std::vector<PointDistributionTensor> records;
  if (!finder_.takesPieces())
    records = tensorsWith(finder_, points, points, settings, {}, frame_);
  else {
    records.resize(points.size());
    const CloudPiece piece = pieceOf(plan, fragment);
    const std::vector<PointDistributionTensor> some =
        pieceTensors(points, piece, settings, {}, monitor);
    std::copy(some.begin(),
              some.end(),
              records.begin() + static_cast<std::ptrdiff_t>(piece.begin));
  }
  fragments::writeRecords(result, fragment, records.data(), sizeof(records[0]));
  return {};
}

std::map<std::string, double>
TensorJob::write(const fragments::Plan& plan,
                 const std::string& folder,
                 std::size_t number,
                 const std::vector<bool>& usable,
                 ProgressMonitor* monitor)
{
  Tally total;
  const auto add = [&](io::Cloud& cloud,
                       const std::vector<PointDistributionTensor>& records,
                       std::size_t left_out) {
    total.add(tallyOf(records, left_out));
    addFeatures(cloud, records, features_);
  };
  writeParts<PointDistributionTensor>({plan, folder, number, usable},
                                      input_,
                                      output_,
                                      unknownTensor(0),
                                      add,
                                      frame_,
                                      monitor);
  return {{"points", total.points},
          {"left_out", total.left_out},
          {"unknown", total.unknown},
          {"neighbors",
           total.mean_neighbors * static_cast<double>(total.points - total.left_out)}};
}

void
TensorJob::report(const std::map<std::string, double>& figures)
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
