// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "virtual_cloud.h"

#include <filesystem>

#include <nlohmann/json.hpp>

#include <linelet/io/file_error.h>

#include "files.h"

namespace linelet::io {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr std::string_view file_scheme = "file://";

/** The file that \a href refers to in the virtual cloud \a path. */
std::string
fileOf(const std::string& path, std::string href)
{
  if (href.rfind(file_scheme, 0) == 0)
    href.erase(0, file_scheme.size());
  else if (href.find("://") != std::string::npos)
    throw FileError(path + ": names " + href +
                    ", which is not on this machine; download it, and name the file");
  fs::path file = href;
  if (file.is_relative())
    file = fs::path(path).parent_path() / file;
  return file.lexically_normal().string();
}

bool
isOverview(const ordered_json& asset)
{
  const auto roles = asset.find("roles");
  if (roles == asset.end() || !roles->is_array())
    return false;
  for (const auto& role : *roles)
    if (role == "overview")
      return true;
  return false;
}

} // namespace

std::vector<std::string>
filesOfVirtualCloud(const std::string& path)
{
  const MappedFile file(path, nullptr);
  const ordered_json all = ordered_json::parse(file.bytes(), nullptr, false);
  const auto features = all.is_object() ? all.find("features") : all.end();
  if (all.is_discarded() || !all.is_object() || features == all.end() ||
      !features->is_array())
    throw FileError(path + ": is not a virtual point cloud: there are no 'features' of "
                           "GeoJSON in it");
  std::vector<std::string> files;
  for (const ordered_json& feature : *features) {
    const auto assets = feature.is_object() ? feature.find("assets") : feature.end();
    if (!feature.is_object() || assets == feature.end() || !assets->is_object())
      continue;
    for (const ordered_json& asset : *assets)
      if (asset.is_object() && asset.contains("href") && asset["href"].is_string() &&
          !isOverview(asset))
        files.push_back(fileOf(path, asset["href"].get<std::string>()));
  }
  if (files.empty())
    throw FileError(path + ": is a virtual point cloud that names no file");
  return files;
}

} // namespace linelet::io
