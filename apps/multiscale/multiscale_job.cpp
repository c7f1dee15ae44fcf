// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "multiscale_job.h"

#include <stdexcept>

#include <linelet/io/output_file.h>

#include "commands.h"
#include "fragments/run_job.h"
#include "options.h"

namespace linelet::apps {

MultiscaleJob::MultiscaleJob(const std::vector<std::string>& arguments)
    : CloudFragmentJob(
          "multiscale",
          "Measures the shape of every point's neighborhood over many radii and "
          "chooses the one that shows a curve best. Adds the shape, direction and "
          "radius of the optimal scale, and summaries of the graphs of linearity and "
          "sphericity; prints the noise rate. All attributes of the input "
          "are kept; points flagged as withheld are ignored and have no shape.\n"
          "Time grows with the number of points within the largest radius: on wires "
          "in proportion to it, on surfaces to its square. A job of more than a few "
          "seconds reports in advance how many neighbors a point has and how long it "
          "will "
          "take. Several inputs use the radii of the first, unless "
          "--radii or --scale-unit sets them; neighbors are found across their "
          "borders. Fragments are computed only on the processor (with tensor "
          "--engine all, also on OpenCL devices).",
          // Two fragments, engine and shapes; or cloud, usable points, engine, shapes
          // and their columns.
          {220, 300})
{
  addOptions(frame_.app, settings_);
  const OptionAdder add(frame_.app);
  add("graphs", graphs_, "CSV file for the graphs of every point");
  frame_.writes(graphs_);
  add("fourth-order",
      fourth_order_,
      "also write the fourth-order tensor over all radii, weighted by this shape "
      "factor, and its major eigentensor");
  describe(shift_, "centroid-shift", "shift-", add);
  addOptions(frame_.app, fragments_);
  frame_.parse(arguments);
  settings_.threads = shift_.threads = frame_.threads;
}

int
MultiscaleJob::runWhole()
{
  const bool several = input_.files().size() > 1;
  if (several && looksAtOneCloud())
    throw std::runtime_error("--graphs, --centroid-shift, --fourth-order and "
                             "--stop-change need a single cloud; give one input, or "
                             "omit them");
  output_.check(input_);
  if (!graphs_.empty())
    io::checkWritable(graphs_);
  if (several)
    runSeveral();
  else
    runOne();
  return frame_.finish();
}

std::unique_ptr<FragmentJob>
makeMultiscaleJob(const std::vector<std::string>& arguments)
{
  return std::make_unique<MultiscaleJob>(arguments);
}

int
runMultiscale(const std::vector<std::string>& arguments)
{
  MultiscaleJob job(arguments);
  return runJob(job, "multiscale", arguments);
}

} // namespace linelet::apps
