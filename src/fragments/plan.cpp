// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/fragments/plan.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include <linelet/io/file_error.h>
#include <linelet/io/output_file.h>

namespace linelet::fragments {

namespace {

using Json = nlohmann::ordered_json;

Json
toJson(const Plan& plan)
{
  Json json = {{"version", plan.version},
               {"command", plan.command},
               {"arguments", plan.arguments},
               {"place", plan.place},
               {"shift", {plan.shift.x(), plan.shift.y(), plan.shift.z()}},
               {"measures", plan.measures},
               {"ghost", plan.ghost},
               {"most_points", plan.most_points}};
  json["inputs"] = Json::array();
  for (const PlannedInput& input : plan.inputs)
    json["inputs"].push_back({{"path", input.path},
                              {"bytes", input.bytes},
                              {"changed", input.changed},
                              {"points", input.extent.points},
                              {"low", input.extent.area.low},
                              {"high", input.extent.area.high},
                              {"low_z", input.low_z},
                              {"high_z", input.high_z}});
  json["cuts"] = Json::array();
  for (const Tiling::Cut& cut : plan.tiling.cuts())
    json["cuts"].push_back({cut.axis, cut.plane, cut.below, cut.above});
  return json;
}

Plan
fromJson(const Json& json)
{
  Plan plan;
  json.at("version").get_to(plan.version);
  json.at("command").get_to(plan.command);
  json.at("arguments").get_to(plan.arguments);
  json.at("place").get_to(plan.place);
  for (int axis = 0; axis < 3; ++axis)
    plan.shift[axis] = json.at("shift").at(static_cast<std::size_t>(axis));
  json.at("measures").get_to(plan.measures);
  json.at("ghost").get_to(plan.ghost);
  json.at("most_points").get_to(plan.most_points);
  for (const Json& one : json.at("inputs")) {
    PlannedInput input;
    one.at("path").get_to(input.path);
    one.at("bytes").get_to(input.bytes);
    one.at("changed").get_to(input.changed);
    one.at("points").get_to(input.extent.points);
    one.at("low").get_to(input.extent.area.low);
    one.at("high").get_to(input.extent.area.high);
    one.at("low_z").get_to(input.low_z);
    one.at("high_z").get_to(input.high_z);
    plan.inputs.push_back(input);
  }
  std::vector<Tiling::Cut> cuts;
  for (const Json& one : json.at("cuts"))
    cuts.push_back({one.at(0), one.at(1), one.at(2), one.at(3)});
  plan.tiling = Tiling(cuts);
  return plan;
}

std::string
pathOf(const std::string& folder)
{
  return (std::filesystem::path(folder) / "plan.json").string();
}

// Bytes of paths that are not UTF-8 are replaced; reading such a path fails.
std::string
textOf(const Plan& plan)
{
  return toJson(plan).dump(1, ' ', false, Json::error_handler_t::replace);
}

} // namespace

std::string
Plan::fingerprint() const
{
  std::uint64_t hash = 0xcbf29ce484222325U; // FNV-1a
  for (const char letter : textOf(*this))
    hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3U;
  char text[17];
  std::snprintf(text, sizeof(text), "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

double
Plan::reach() const
{
  double largest = 1;
  for (const PlannedInput& input : inputs)
    for (std::size_t a = 0; a < 2; ++a)
      largest = std::max({largest,
                          std::abs(input.extent.area.low[a]),
                          std::abs(input.extent.area.high[a])});
  return ghost + 1e-12 * largest;
}

std::vector<std::size_t>
Plan::inputsOf(std::size_t number) const
{
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto boxes = tiling.near(inputs[i].extent.area, reach());
    if (std::find(boxes.begin(), boxes.end(), number) != boxes.end())
      found.push_back(i);
  }
  return found;
}

PlannedInput
stateOf(const std::string& path)
{
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0)
    throw io::FileError(path + ": cannot be read (" + std::strerror(errno) +
                        "); check the path and its permissions");
  PlannedInput input;
  input.path = path;
  input.bytes = static_cast<std::uint64_t>(status.st_size);
  input.changed =
      std::int64_t{status.st_mtim.tv_sec} * 1000000000 + status.st_mtim.tv_nsec;
  return input;
}

void
checkInputs(const Plan& plan)
{
  for (const PlannedInput& planned : plan.inputs) {
    const PlannedInput now = stateOf(planned.path);
    if (now.bytes != planned.bytes || now.changed != planned.changed)
      throw io::FileError(planned.path +
                          ": has changed since the plan was made; plan again");
  }
}

void
savePlan(const Plan& plan, const std::string& folder)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw io::FileError(folder + ": cannot be created (" + error.message() +
                        "); check that its parent folder is writable");
  io::OutputFile file(pathOf(folder));
  file.write(textOf(plan) + '\n');
  file.commit();
}

Plan
loadPlan(const std::string& folder)
{
  const std::string path = pathOf(folder);
  std::ifstream file(path);
  if (!file)
    throw io::FileError(path + ": there is no plan; make one with linelet plan");
  try {
    return fromJson(Json::parse(file));
  }
  catch (const std::exception&) {
    throw io::FileError(path + ": is damaged; remove its folder and plan again");
  }
}

} // namespace linelet::fragments
