// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "copc_index.h"

#include <algorithm>
#include <cmath>

#include "io/source.h"

namespace linelet::io {

namespace {

constexpr std::size_t info_size = 160, entry_size = 32;
constexpr int most_levels = 31; // bits of a node's coordinates

} // namespace

CopcIndex::CopcIndex(std::string_view file, std::string_view info)
{
  if (info.size() < info_size)
    throw laz::Error("its COPC record has " + std::to_string(info.size()) +
                     " bytes of 160");
  const double half = load<double>(info.data() + 24);
  for (int axis = 0; axis < 3; ++axis)
    low_[axis] = load<double>(info.data() + 8 * axis) - half;
  side_ = 2 * half;
  spacing_ = load<double>(info.data() + 32);
  if (!low_.allFinite() || !(half > 0) || !std::isfinite(half))
    throw laz::Error("its COPC record describes no cube");
  std::vector<Page> pages = {
      {load<std::uint64_t>(info.data() + 40), load<std::uint64_t>(info.data() + 48)}};
  while (!pages.empty()) {
    const Page page = pages.back();
    pages.pop_back();
    readPage(file, page, pages);
  }
  std::sort(nodes_.begin(), nodes_.end(), [](const Node& a, const Node& b) {
    return a.at < b.at;
  });
  for (const Node& node : nodes_)
    levels_ = std::max(levels_, node.level + 1);
}

void
CopcIndex::readPage(std::string_view file, Page page, std::vector<Page>& pages)
{
  if (page.at > file.size() || page.bytes > file.size() - page.at)
    throw laz::Error("a page of its COPC hierarchy, at byte " +
                     std::to_string(page.at) + ", is outside of the file");
  const char* entries = file.data() + page.at;
  for (std::size_t i = 0; i < page.bytes / entry_size; ++i) {
    // Stops at pages that refer to themselves.
    if (++entries_ > file.size() / entry_size)
      throw laz::Error(
          "its COPC hierarchy has more entries than the file has room for");
    const char* entry = entries + i * entry_size;
    Node node{};
    node.level = load<std::int32_t>(entry);
    node.x = load<std::int32_t>(entry + 4);
    node.y = load<std::int32_t>(entry + 8);
    node.z = load<std::int32_t>(entry + 12);
    node.at = load<std::uint64_t>(entry + 16);
    node.bytes = load<std::uint32_t>(entry + 24);
    const auto points = load<std::int32_t>(entry + 28);
    if (points == -1)
      pages.push_back({node.at, node.bytes});
    else if (points > 0) {
      node.points = static_cast<std::uint32_t>(points);
      if (node.level < 0 || node.level >= most_levels)
        throw laz::Error("its COPC hierarchy has a node on level " +
                         std::to_string(node.level));
      nodes_.push_back(node);
    }
  }
}

std::vector<laz::Chunk>
CopcIndex::chunks(const Window& window, double resolution) const
{
  std::vector<laz::Chunk> chunks;
  std::size_t first = 0;
  for (const Node& node : nodes_) {
    // The points of level l are spacing / 2^l apart.
    if (resolution > 0 && std::ldexp(spacing_, 1 - node.level) <= resolution &&
        node.level > 0)
      continue;
    const double side = std::ldexp(side_, -node.level);
    const Point low = low_ + side * Point(node.x, node.y, node.z);
    if (!window.meets(low, low + Point::Constant(side)))
      continue;
    chunks.push_back(
        {static_cast<std::size_t>(node.at), node.bytes, true, first, node.points});
    first += node.points;
  }
  return chunks;
}

} // namespace linelet::io
