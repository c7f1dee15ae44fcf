// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tensor_job.h"

#include <cmath>
#include <type_traits>

#include <linelet/search/scale_unit.h>

#include "commands.h"
#include "fragments/run_job.h"
#include "options.h"
#include "tensor_among_files.h"
#include "tensor_tally.h"

namespace linelet::apps {

TensorJob::TensorJob(const std::vector<std::string>& arguments)
    : CloudFragmentJob(
          "tensor",
          "Measures the shape of every point's neighborhood: tensor, eigenvalues, "
          "major direction, normal, linearity, planarity, sphericity and number of "
          "neighbors, added to the attributes of the input. Without --radius, --knn "
          "or a field, the radius is three times the scale unit D. Points "
          "flagged "
          "as withheld are ignored and have no shape.",
          // Two fragments, engine and records; or cloud, usable points, engine, records
          // and their columns.
          {200, 300})
{
  const OptionAdder add(frame_.app);
  // The tool has one engine more than the settings.
  describe(settings_, [&](const char* name, auto& value, const char* help) {
    if constexpr (std::is_same_v<decltype(value), Engine&>)
      add(name,
          finder_.engine,
          (std::string(help) + "; all: the grid and every OpenCL device (see --device) "
                               "at the same time, in fragments")
              .c_str());
    else
      add(name, value, help);
  });
  add("features",
      features_,
      "attributes to write: shape (tensor, eigenvalues, directions, shape factors, "
      "neighbors), all, or a list of names, also of verticality, omnivariance, "
      "eigenentropy, "
      "surface_variation");
  add("radius-field", fields_.radius, "attribute that holds the radius of every point");
  add("knn-field",
      fields_.knn,
      "attribute that holds the number of nearest points of every point");
  add("search",
      finder_.search,
      "search that finds the neighbors, instead of --engine: linelet's kd-tree or "
      "grid, "
      "or PCL's searches; all find the same neighbors");
  add("device",
      finder_.device,
      "OpenCL device by number or part of its name; linelet devices lists them");
  addOptions(frame_.app, fragments_);
  add("schedule",
      schedule_,
      "Fragments: heuristic of Grasso et al. (2015) that assigns them to the devices "
      "of --engine all");
  frame_.parse(arguments);
  settings_.threads = frame_.threads;
  settle(finder_);
}

int
TensorJob::runWhole()
{
  output_.check(input_);
  Tally total;
  double scale_unit = std::nan("");
  std::size_t withheld = 0, ignored = 0;
  for (std::size_t i = 0; i < input_.files().size(); ++i) {
    io::Cloud cloud = input_.read(i);
    const io::UsablePoints usable = input_.usable(cloud);
    if (settings_.radius == 0 && settings_.k == 0 && fields_.radius.empty() &&
        fields_.knn.empty()) {
      scale_unit = scaleUnit(usable.points(), 1024, 1, frame_.threads);
      frame_.summary["scale_unit"] = scale_unit;
      settings_.radius = chooseRadius(scale_unit, input_.files()[i]);
    }
    const std::vector<PointDistributionTensor> records = estimateAmongOthers(
        input_, i, cloud, usable, settings_, finder_, fields_, frame_);
    frame_.lap("tensor");
    addFeatures(cloud, records, features_);
    const std::string path = output_.pathFor(input_, i);
    output_.write(cloud, path);

    const Tally tally = tallyOf(records, usable.leftOut());
    print(tally, path, settings_, finder_, fields_);
    printUnknown(tally, scale_unit, usable.points());
    total.add(tally);
    withheld += usable.withheld();
    ignored += usable.ignored();
  }
  summarize(frame_.summary, total, settings_, finder_, fields_);
  frame_.summary["withheld"] = withheld;
  frame_.summary["ignored"] = ignored;
  return frame_.finish();
}

std::unique_ptr<FragmentJob>
makeTensorJob(const std::vector<std::string>& arguments)
{
  return std::make_unique<TensorJob>(arguments);
}

int
runTensor(const std::vector<std::string>& arguments)
{
  TensorJob job(arguments);
  return runJob(job, "tensor", arguments);
}

} // namespace linelet::apps
