// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/fragments/records.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>

#include <linelet/io/file_error.h>
#include <linelet/io/output_file.h>

namespace linelet::fragments {

namespace {

// A table of sections, then the places and records of each.
struct Head {
  std::uint64_t input, count, places_at, records_at;
};

constexpr std::size_t block = 16384; // records at a time

template <class T>
std::string_view
bytesOf(const T* values, std::size_t count)
{
  return {reinterpret_cast<const char*>(values), count * sizeof(T)};
}

[[noreturn]] void
damaged(const std::string& path)
{
  throw io::FileError(path + ": is missing or damaged; remove its entry in the folder "
                             "task beside it and work on it again");
}

} // namespace

std::string
resultPath(const std::string& folder, std::size_t number)
{
  char name[48];
  std::snprintf(name, sizeof(name), "results/%06zu.bin", number);
  return (std::filesystem::path(folder) / name).string();
}

void
writeRecords(const std::string& path,
             const Fragment& fragment,
             const void* records,
             std::size_t bytes,
             std::size_t first)
{
  std::error_code ignored; // writing the file reports it
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(),
                                      ignored);
  std::vector<Head> heads;
  for (const Section& section : fragment.sections) {
    Head head{section.input, 0, 0, 0};
    for (std::size_t i = 0; i < section.count; ++i)
      head.count += fragment.core[section.first + i] ? 1 : 0;
    heads.push_back(head);
  }
  const std::uint64_t number = heads.size();
  std::uint64_t at = sizeof(number) + number * sizeof(Head);
  for (Head& head : heads) {
    head.places_at = at;
    head.records_at = at + head.count * sizeof(std::uint32_t);
    at = head.records_at + head.count * bytes;
  }
  io::OutputFile file(path);
  file.write(bytesOf(&number, 1));
  file.write(bytesOf(heads.data(), heads.size()));
  for (const Section& section : fragment.sections) {
    std::vector<std::uint32_t> places;
    std::string chosen;
    for (std::size_t i = section.first; i < section.first + section.count; ++i)
      if (fragment.core[i])
        places.push_back(fragment.places[i]);
    file.write(bytesOf(places.data(), places.size()));
    for (std::size_t i = section.first; i < section.first + section.count; ++i) {
      if (fragment.core[i])
        chosen.append(static_cast<const char*>(records) + (i - first) * bytes, bytes);
      if (chosen.size() > block * 64) {
        file.write(chosen);
        chosen.clear();
      }
    }
    file.write(chosen);
  }
  file.commit();
}

RecordStream::RecordStream(const Plan& plan,
                           const std::string& folder,
                           std::size_t input,
                           std::size_t bytes,
                           const std::vector<bool>& usable)
    : bytes_(bytes)
{
  for (const std::size_t fragment :
       plan.tiling.near(plan.inputs.at(input).extent.area, plan.reach())) {
    if (!usable.at(fragment))
      continue;
    const std::string path = resultPath(folder, fragment);
    std::ifstream file(path, std::ios::binary);
    std::uint64_t number = 0;
    file.read(reinterpret_cast<char*>(&number), sizeof(number));
    if (!file || number > plan.inputs.size())
      damaged(path);
    std::vector<Head> heads(number);
    file.read(reinterpret_cast<char*>(heads.data()),
              static_cast<std::streamsize>(number * sizeof(Head)));
    if (!file)
      damaged(path);
    for (const Head& head : heads)
      if (head.input == input && head.count > 0)
        parts_.push_back({path, head.places_at, head.records_at, head.count, 0, {}, 0});
  }
}

void
RecordStream::take(Part& part, std::size_t count, char* records)
{
  const std::size_t behind = first_ + count;
  std::ifstream file;
  std::string values;
  const auto read = [&](std::uint64_t at, void* to, std::size_t bytes) {
    if (!file.is_open())
      file.open(part.path, std::ios::binary);
    file.seekg(static_cast<std::streamoff>(at));
    file.read(static_cast<char*>(to), static_cast<std::streamsize>(bytes));
    if (!file)
      damaged(part.path);
  };
  while (part.taken < part.count) {
    if (part.used == part.places.size()) {
      part.places.resize(std::min<std::uint64_t>(block, part.count - part.taken));
      part.used = 0;
      read(part.places_at + part.taken * sizeof(std::uint32_t),
           part.places.data(),
           part.places.size() * sizeof(std::uint32_t));
    }
    const auto from = part.places.begin() + static_cast<std::ptrdiff_t>(part.used);
    const auto to = std::lower_bound(from, part.places.end(), behind);
    const auto some = static_cast<std::size_t>(to - from);
    if (some == 0)
      return;
    values.resize(some * bytes_);
    read(part.records_at + part.taken * bytes_, values.data(), values.size());
    for (std::size_t i = 0; i < some; ++i)
      std::memcpy(records + (part.places[part.used + i] - first_) * bytes_,
                  values.data() + i * bytes_,
                  bytes_);
    part.used += some;
    part.taken += some;
    if (part.used < part.places.size())
      return;
  }
}

void
RecordStream::next(std::size_t count, void* records)
{
  for (Part& part : parts_)
    take(part, count, static_cast<char*>(records));
  first_ += count;
}

} // namespace linelet::fragments
