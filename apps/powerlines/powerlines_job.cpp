// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerlines_job.h"

#include <cstdio>
#include <filesystem>
#include <limits>

#include "commands.h"
#include "fragments/run_job.h"
#include "options.h"
#include "powerlines_text.h"
#include "run_date.h"
#include "version.h"

namespace linelet {

namespace apps {

namespace {

enum class ClassifiedEnding { AsInput, Las, Laz };

} // namespace

} // namespace apps

template <>
struct Names<apps::ClassifiedEnding> {
  static constexpr std::string_view kind = "ending";
  static constexpr std::array<std::pair<apps::ClassifiedEnding, std::string_view>, 3>
      table = {{
          {apps::ClassifiedEnding::AsInput, "as input"},
          {apps::ClassifiedEnding::Las, "las"},
          {apps::ClassifiedEnding::Laz, "laz"},
      }};
};

namespace apps {

using powerline::PowerLineNetwork;

namespace {

bool
isLaz(const std::string& path)
{
  const std::string ending = path.size() > 4 ? path.substr(path.size() - 4) : "";
  return ending == ".laz" || ending == ".LAZ";
}

} // namespace

PowerlinesJob::PowerlinesJob(const std::vector<std::string>& arguments)
    : FragmentJob(
          "powerlines",
          "Finds every wire of an airborne or UAV scan: classified cloud, vectors, "
          "report. Points flagged as withheld are ignored and stay in the "
          "classified cloud as they are; overlap, synthetic and key points are "
          "used like others.",
          // Measured in addition to the program itself: 100 to 135 with the next
          // fragment loaded beside; in one piece, 102 for 5 million points, 91 for 10,
          // 82 for 30.
          BytesPerPoint{135, 105},
          CloudInput::Use::Lengths,
          "point file, z up, meters or feet (by its reference system); classes are "
          "not needed")
{
  frame_.addOutput("OUTDIR",
                   folder_,
                   "folder for classified.las or .laz, wires and hazards as .geojson, "
                   ".gpkg and .dxf, clearances.csv, crossings.csv, fall_in.csv, "
                   "summary.json and report.html; created if missing");
  addOptions(frame_.app, settings_);
  addOptions(frame_.app, hazards_);
  frame_.reads(hazards_.limits);
  frame_.reads(hazards_.conductor);
  addOptions(frame_.app, output_.classes);
  addOptions(frame_.app, output_.vectors);
  const OptionAdder add(frame_.app);
  add("overwrite", overwrite_, "replace results of another input in OUTDIR");
  add("reviewed",
      reviewed_,
      "file of wires reviewed in linelet-view or a GIS (columns review, review_class, "
      "review_note): rejected ones are left out, accepted ones are certain");
  frame_.reads(reviewed_);
  addOptions(frame_.app, fragments_);
  add("buffer",
      buffer_,
      "Fragments: overlap, meters: at least the longest span with the supports at its "
      "ends");
  ClassifiedEnding ending = ClassifiedEnding::AsInput;
  add("classified", ending, "ending of the classified cloud");
  frame_.parse(arguments);
  output_.compress =
      ending == ClassifiedEnding::Laz ||
      (ending == ClassifiedEnding::AsInput && isLaz(input_.files().front()));
  frame_.checkOutputs(powerline::powerLineFiles(folder_, output_.compress));
  powerline::check(output_.classes);
  powerline::check(hazards_);
  settings_.threads = output_.threads = frame_.threads;
  settings_.points = output_.points = input_.classes();
  output_.clearance = settings_.clearance;
  const std::filesystem::path input(input_.path());
  output_.source = // of a folder "tiles/", too
      (input.has_filename() ? input : input.parent_path()).filename().string();
  output_.provenance = {
      "linelet " LINELET_VERSION, runDate(), input_.files(), frame_.settings()};
}

void
PowerlinesJob::warnOfUnits(const std::string& wkt)
{
  const io::Units units = io::unitsOf(wkt);
  if (!units.height_stated && !units.areMeters())
    frame_.warn("the reference system has no unit of heights; they are taken as " +
                units.height_name + ", like x and y");
  if (wkt.empty())
    frame_.warn(input_.path() +
                " has no reference system: its coordinates are taken as meters");
}

void
PowerlinesJob::tell(const PowerLineNetwork& network,
                    double points,
                    const std::vector<std::string>& files)
{
  printPowerLines(network, output_.hazards, points, settings_.clearance);
  for (const std::string& file : files)
    std::printf("%s\n", file.c_str());
  frame_.summary["points"] = static_cast<std::size_t>(points);
  summarizePowerLines(frame_.summary, network, output_.hazards, settings_.clearance);
  frame_.summary["files"] = files;
}

void
PowerlinesJob::refuseOtherResults(const std::string& other) const
{
  if (!other.empty() && !overwrite_)
    throw io::FileError(folder_ + ": holds the results of " + other +
                        "; name another folder, or replace them with --overwrite");
}

std::unique_ptr<FragmentJob>
makePowerlinesJob(const std::vector<std::string>& arguments)
{
  return std::make_unique<PowerlinesJob>(arguments);
}

int
runPowerlines(const std::vector<std::string>& arguments)
{
  PowerlinesJob job(arguments);
  return runJob(job, "powerlines", arguments);
}

} // namespace apps

} // namespace linelet
