// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/powerline_output/output_files.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include <linelet/io/output_check.h>
#include <linelet/io/output_file.h>
#include <linelet/io/point_file.h>

namespace linelet::powerline {

namespace {

void
writeText(const std::string& path, const std::string& text)
{
  io::OutputFile file(path);
  file.write(text);
  file.commit();
}

std::string
unexplainedWarning(const PowerLineNetwork& network)
{
  char length[32];
  std::snprintf(length, sizeof length, "%.0f", unexplainedLength(network));
  return std::string(length) +
         " m above ground look like lines but belong to no wire or support found: "
         "wires may be missing (layer unexplained)";
}

} // namespace

void
makeOutputFolder(const std::string& folder, bool compress)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored))
    throw io::FileError("cannot create the folder " + folder + ": " +
                        (error ? error.message() : "a file has that name") +
                        "; name a folder that can be created or written to");
  io::checkCloudOutput(powerLineFiles(folder, compress).front());
}

std::vector<std::string>
writeNetworkFiles(const std::string& folder,
                  const io::Cloud& cloud,
                  const PowerLineNetwork& network,
                  const OutputOptions& options,
                  std::vector<std::string>* warnings,
                  ProgressMonitor* monitor)
{
  makeOutputFolder(folder, options.compress);
  check(options.classes);
  const std::vector<std::string> paths = powerLineFiles(folder, options.compress);
  const auto layers = powerLineLayers(cloud, network, options);
  const auto hazards = hazardLayers(cloud, options.hazards);
  const std::string report = powerLineReport(cloud, network, options, monitor);
  std::vector<std::vector<std::string>> told(paths.size());
  const auto writeFile = [&](std::size_t i) {
    if (i == 10)
      return writeText(paths[i], powerLineSummary(cloud, network, options));
    if (i == 11)
      return writeText(paths[i], report);
    const std::filesystem::path path = paths[i];
    io::VectorOptions vectors = options.vectors;
    if (path.extension() == ".geojson" && !vectors.keep_crs)
      vectors.output_crs.clear(); // its standard prescribes WGS 84
    const auto one =
        std::find_if(hazards.begin(), hazards.end(), [&](const auto& layer) {
          return path.extension() == ".csv" && layer.name == path.stem().string();
        });
    const auto& content = i <= 3 ? layers : hazards;
    io::writeLayers(paths[i],
                    one == hazards.end() ? content : std::vector<io::VectorLayer>{*one},
                    cloud.wkt,
                    i <= 3 ? &told[i] : nullptr,
                    monitor,
                    vectors);
  };
  // One by one: GDAL's drivers occasionally crash when they write concurrently.
  for (std::size_t i = 1; i < paths.size(); ++i)
    writeFile(i);
  if (warnings != nullptr)
    for (const auto& sentences : told)
      warnings->insert(warnings->end(), sentences.begin(), sentences.end());
  return paths;
}

void
warnOfDoubts(const PowerLineNetwork& network,
             std::size_t unconfirmed,
             const ClassScheme& classes,
             std::vector<std::string>* warnings)
{
  if (warnings == nullptr)
    return;
  if (unconfirmed > 0 && classes.existing == ExistingClasses::Keep)
    warnings->push_back(std::to_string(unconfirmed) + " points came with class " +
                        std::to_string(classes.wire) + " or " +
                        std::to_string(classes.tower) +
                        " but belong to no wire or support found; they keep it "
                        "(--existing-classes reset makes them unclassified)");
  if (muchIsUnexplained(network))
    warnings->push_back(unexplainedWarning(network));
}

std::vector<std::string>
writePowerLineFiles(const std::string& folder,
                    io::Cloud cloud,
                    const PowerLineNetwork& network,
                    const OutputOptions& options,
                    std::vector<std::string>* warnings,
                    ProgressMonitor* monitor)
{
  std::vector<std::string> paths =
      writeNetworkFiles(folder, cloud, network, options, warnings, monitor);
  const std::size_t unconfirmed = classify(cloud, network, options.classes);
  warnOfDoubts(network, unconfirmed, options.classes, warnings);
  io::WriteOptions how;
  how.threads = options.threads;
  io::writeCloud(paths[0], cloud, how, warnings, monitor);
  return paths;
}

} // namespace linelet::powerline
