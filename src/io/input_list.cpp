// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/io/input_list.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <linelet/io/point_file.h>

#include "files.h"
#include "virtual_cloud.h"

namespace linelet::io {

namespace {

namespace fs = std::filesystem;

bool
isPointFile(const fs::path& path)
{
  static const char* const endings[] = {
      ".las", ".laz", ".pcd", ".ply", ".h5", ".xyz", ".txt", ".csv", ".xy"};
  const std::string ending = endingOf(path.string());
  return std::any_of(std::begin(endings), std::end(endings), [&](const char* known) {
    return ending == known;
  });
}

std::vector<std::string>
filesOfFolder(const std::string& folder)
{
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && isPointFile(entry.path()) &&
        entry.path().filename().string()[0] != '.')
      files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  if (files.empty())
    throw FileError(folder + ": is a folder without point files");
  return files;
}

/** Lines of the list \a path, as paths; empty if the first is not a file. */
std::vector<std::string>
filesOfList(const std::string& path)
{
  std::ifstream list(path);
  std::vector<std::string> files;
  std::string line;
  for (std::size_t number = 1; std::getline(list, line); ++number) {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' '))
      line.pop_back();
    if (line.empty() || line[0] == '#')
      continue;
    fs::path file = line;
    if (file.is_relative())
      file = fs::path(path).parent_path() / file;
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored)) {
      if (files.empty())
        return {}; // it is points as text
      throw FileError(path + ": line " + std::to_string(number) + " names " +
                      file.string() + ", which is not a file");
    }
    files.push_back(file.string());
  }
  return files;
}

/** The files that \a name stands for; empty if it is a point file itself. */
std::vector<std::string>
filesBehind(const std::string& name)
{
  std::error_code ignored;
  if (fs::is_directory(name, ignored))
    return filesOfFolder(name);
  const std::string ending = endingOf(name);
  if (ending == ".vpc")
    return filesOfVirtualCloud(name);
  return ending == ".txt" ? filesOfList(name) : std::vector<std::string>();
}

} // namespace

InputList
findInputs(const std::vector<std::string>& names)
{
  InputList list;
  for (const std::string& name : names) {
    std::vector<std::string> files = filesBehind(name);
    list.several = list.several || !files.empty();
    if (files.empty())
      files.push_back(name);
    for (std::string& file : files)
      if (std::find(list.files.begin(), list.files.end(), file) == list.files.end())
        list.files.push_back(std::move(file));
  }
  list.several = list.several || list.files.size() > 1;
  return list;
}

} // namespace linelet::io
