// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "classified_copy.h"

#include <algorithm>
#include <future>
#include <optional>
#include <set>
#include <utility>

#include <linelet/io/cloud_sink.h>
#include <linelet/io/merge.h>
#include <linelet/io/point_stream.h>
#include <linelet/support/threads.h>

namespace linelet::apps {

using powerline::PowerLineNetwork;

namespace {

constexpr std::size_t block_size = 400000; // points at a time

/** The attributes common to all files. */
std::vector<std::string>
commonAttributes(const std::vector<std::string>& files,
                 const io::ReadOptions& options,
                 std::vector<std::string>* warnings)
{
  std::vector<std::string> common;
  std::set<std::string> lost;
  for (std::size_t i = 0; i < files.size(); ++i) {
    io::Cloud cloud;
    io::PointStream(files[i], options, 1).next(cloud);
    if (i == 0)
      for (const io::Column& column : cloud.columns)
        common.push_back(column.name);
    for (const io::Column& column : cloud.columns)
      if (std::find(common.begin(), common.end(), column.name) == common.end())
        lost.insert(column.name);
    common.erase(std::remove_if(common.begin(),
                                common.end(),
                                [&](const std::string& name) {
                                  if (cloud.find(name) != nullptr)
                                    return false;
                                  lost.insert(name);
                                  return true;
                                }),
                 common.end());
  }
  if (!lost.empty()) {
    std::string names;
    for (const std::string& name : lost)
      names += " " + name;
    warnings->push_back("attributes that not all inputs have are left out:" + names);
  }
  return common;
}

/** Properties of the cloud of several files. */
io::Cloud
withoutPoints(const io::Cloud& cloud, const std::vector<std::string>& attributes)
{
  io::Cloud empty = cloud;
  empty.points.clear();
  empty.columns.clear();
  for (const io::Column& column : cloud.columns)
    if (std::find(attributes.begin(), attributes.end(), column.name) !=
        attributes.end()) {
      empty.columns.push_back(column);
      std::visit([](auto& values) { values.clear(); }, empty.columns.back().values);
    }
  return empty;
}

/** Blocks of points, each read while the one before is processed. */
class ReadAhead {
public:
  ReadAhead(io::PointStream& stream, unsigned threads)
      : stream_(stream),
        policy_(threadCount(threads) > 1 ? std::launch::async : std::launch::deferred)
  {
    // The first block is read right away, so that its warnings come in order.
    read(std::launch::deferred);
  }

  bool
  next(io::Cloud& cloud)
  {
    std::optional<io::Cloud> block = ahead_.get();
    if (!block)
      return false;
    cloud = std::move(*block);
    read(policy_);
    return true;
  }

private:
  void
  read(std::launch policy)
  {
    ahead_ = std::async(policy, [this] {
      std::optional<io::Cloud> block(std::in_place);
      if (!stream_.next(*block))
        block.reset();
      return block;
    });
  }

  io::PointStream& stream_;
  std::launch policy_;
  std::future<std::optional<io::Cloud>> ahead_;
};

} // namespace

CopiedPoints
copyClassified(const std::string& path,
               const std::vector<std::string>& files,
               const io::ReadOptions& options,
               const powerline::ClassScheme& classes,
               const std::string& wkt,
               const std::vector<powerline::Wire>& wires,
               const LabelBlock& label,
               std::vector<std::string>* warnings,
               ProgressMonitor* monitor)
{
  const bool several = files.size() > 1;
  std::vector<std::string> common;
  if (several)
    common = commonAttributes(files, options, warnings);
  io::CloudSink sink(path, warnings, monitor, options.threads);
  io::Cloud first, block;
  PowerLineNetwork found;
  found.wires = wires; // reviews name classes
  CopiedPoints copied;
  for (std::size_t i = 0; i < files.size(); ++i) {
    io::PointStream stream(files[i], options, block_size, warnings, monitor);
    ReadAhead blocks(stream, options.threads);
    for (bool begun = i > 0; blocks.next(block); begun = true) {
      if (several && !begun)
        first = withoutPoints(block, common);
      io::Cloud cloud = several ? first : std::move(block);
      if (several)
        io::append(cloud, block);
      if (cloud.wkt.empty())
        cloud.wkt = wkt;
      label(i, cloud, found);
      copied.unconfirmed += powerline::classify(cloud, found, classes);
      sink.add(cloud);
      copied.points += static_cast<double>(cloud.points.size());
    }
  }
  sink.commit();
  return copied;
}

} // namespace linelet::apps
