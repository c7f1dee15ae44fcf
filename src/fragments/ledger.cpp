// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/fragments/ledger.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include <linelet/io/output_file.h>

namespace linelet::fragments {

using Json = nlohmann::ordered_json;

Ledger::Ledger(std::string folder, std::string fingerprint)
    : folder_(std::move(folder)), fingerprint_(std::move(fingerprint))
{
}

std::string
Ledger::path(const char* kind, std::size_t number) const
{
  char name[32];
  std::snprintf(name, sizeof(name), "%06zu.json", number);
  return (std::filesystem::path(folder_) / kind / name).string();
}

std::optional<Ledger::Entry>
Ledger::find(const char* kind, std::size_t number) const
{
  std::ifstream file(path(kind, number));
  if (!file)
    return {};
  try {
    const Json json = Json::parse(file);
    if (json.at("fingerprint") != fingerprint_)
      return {};
    Entry entry;
    json.at("done").get_to(entry.done);
    json.at("reason").get_to(entry.reason);
    json.at("points").get_to(entry.points);
    json.at("seconds").get_to(entry.seconds);
    json.at("peak_bytes").get_to(entry.peak_bytes);
    json.at("device").get_to(entry.device);
    json.at("figures").get_to(entry.figures);
    for (const Json& piece : json.at("pieces"))
      entry.pieces[piece.at(0)] = piece.at(1);
    return entry;
  }
  catch (const std::exception&) {
    return {}; // unreadable: counts as missing
  }
}

bool
Ledger::done(const char* kind, std::size_t number) const
{
  const auto entry = find(kind, number);
  return entry && entry->done;
}

void
Ledger::write(const char* kind, std::size_t number, const Entry& entry) const
{
  Json json = {{"fingerprint", fingerprint_},
               {"done", entry.done},
               {"reason", entry.reason},
               {"points", entry.points},
               {"seconds", entry.seconds},
               {"peak_bytes", entry.peak_bytes},
               {"device", entry.device},
               {"figures", entry.figures},
               {"pieces", Json::array()}};
  for (const auto& [fragment, points] : entry.pieces)
    json["pieces"].push_back({fragment, points});
  const std::string file = path(kind, number);
  std::error_code ignored; // writing the file reports it
  std::filesystem::create_directories(std::filesystem::path(file).parent_path(),
                                      ignored);
  io::OutputFile out(file);
  out.write(json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n');
  out.commit();
}

void
Ledger::forgetFailures() const
{
  namespace fs = std::filesystem;
  for (const char* kind : {cut, task, output}) {
    std::error_code none; // counts as no entry
    for (const auto& file : fs::directory_iterator(fs::path(folder_) / kind, none)) {
      std::size_t number = 0;
      if (std::sscanf(file.path().filename().c_str(), "%zu.json", &number) != 1)
        continue;
      if (const auto entry = find(kind, number); entry && !entry->done)
        fs::remove(path(kind, number), none);
    }
  }
}

void
Ledger::removeLocks() const
{
  namespace fs = std::filesystem;
  for (const char* kind : {cut, task, output}) {
    std::error_code none;
    std::vector<fs::path> locks;
    for (const auto& file : fs::directory_iterator(fs::path(folder_) / kind, none))
      if (file.path().extension() == ".lock")
        locks.push_back(file.path());
    for (const fs::path& lock : locks)
      fs::remove(lock, none);
  }
}

WorkLock::WorkLock(const std::string& path)
{
  std::error_code ignored;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(),
                                      ignored);
  file_ = ::open((path + ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  // Without a lock two workers do the same work twice, with the same result.
  if (file_ >= 0)
    ::flock(file_, LOCK_EX);
}

WorkLock::~WorkLock()
{
  if (file_ >= 0)
    ::close(file_);
}

} // namespace linelet::fragments
