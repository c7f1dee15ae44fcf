// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "staged_file.h"

#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include <sys/stat.h>
#include <unistd.h>

#include <linelet/io/file_error.h>
#include <linelet/io/unfinished_files.h>

#include "files.h"

namespace linelet::io {

namespace fs = std::filesystem;

namespace {

/** \brief The paths of all files under construction. Never destroyed, as a signal may
 * arrive during exit. */
struct Register {
  std::mutex mutex;
  std::set<std::string> places;

  static Register&
  instance()
  {
    static auto* all = new Register;
    return *all;
  }
};

/** \a path, or its target if it is a symbolic link. */
fs::path
targetOf(const std::string& path)
{
  std::error_code error;
  if (fs::is_symlink(path, error))
    return fs::weakly_canonical(path, error);
  return path;
}

bool
isSpecial(const std::string& path)
{
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) &&
         !S_ISDIR(status.st_mode);
}

/** Prefix of the names of files under construction, before the process id. */
std::string
leadOfHost()
{
  char host[HOST_NAME_MAX + 1] = "";
  ::gethostname(host, sizeof host - 1);
  return ".part-" + std::string(host) + "-";
}

std::string
placeFor(const std::string& path)
{
  if (isSpecial(path))
    return path;
  fs::path place = targetOf(path);
  const std::string name = place.filename().string();
  if (name.size() > NAME_MAX)
    throw FileError(cannotWrite(path, ENAMETOOLONG));
  const std::string lead = leadOfHost() + std::to_string(::getpid()) + "-";
  // SQLite appends to the name for its journal.
  constexpr std::size_t longest = NAME_MAX - 16;
  if (lead.size() + name.size() <= longest)
    place.replace_filename(lead + name);
  else
    place.replace_filename(lead + std::to_string(std::hash<std::string>()(name)) +
                           place.extension().string().substr(0, 16));
  return place.string();
}

/** Removes \a place and what writers keep beside it: journals of SQLite, entities of
 * the DXF writer. */
void
removeWithCompanions(const std::string& place)
{
  for (const char* ending : {"", "-journal", "-wal", "-shm", ".tmp"})
    std::remove((place + ending).c_str());
}

} // namespace

StagedFile::StagedFile(const std::string& path) : path_(path), place_(placeFor(path))
{
  std::error_code ignored;
  if (fs::is_directory(path, ignored))
    throw FileError(cannotWrite(path, EISDIR));
  if (direct())
    return;
  Register& all = Register::instance();
  const std::lock_guard<std::mutex> lock(all.mutex);
  all.places.insert(place_);
}

StagedFile::~StagedFile()
{
  if (direct())
    return;
  Register& all = Register::instance();
  const std::lock_guard<std::mutex> lock(all.mutex);
  if (all.places.erase(place_) > 0)
    removeWithCompanions(place_);
}

void
StagedFile::publish()
{
  if (direct())
    return;
  Register& all = Register::instance();
  const std::lock_guard<std::mutex> lock(all.mutex);
  std::error_code error;
  fs::rename(place_, targetOf(path_), error);
  if (error)
    throw FileError(cannotWrite(path_, error.value()));
  all.places.erase(place_);
}

void
removeLeftovers(const std::string& folder)
{
  const std::string lead = leadOfHost();
  std::vector<fs::path> leftovers;
  std::error_code none; // an unreadable folder is left alone
  for (const auto& file : fs::directory_iterator(folder, none)) {
    const std::string name = file.path().filename().string();
    if (name.compare(0, lead.size(), lead) != 0)
      continue;
    const pid_t process = std::atoi(name.c_str() + lead.size());
    if (process > 0 && ::kill(process, 0) != 0 && errno == ESRCH)
      leftovers.push_back(file.path());
  }
  for (const fs::path& file : leftovers)
    fs::remove(file, none);
}

void
removeUnfinishedFiles()
{
  Register& all = Register::instance();
  all.mutex.lock(); // never unlocked: nothing may be created or published anymore
  for (const std::string& place : all.places)
    removeWithCompanions(place);
}

} // namespace linelet::io
