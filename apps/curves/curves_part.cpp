// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "curves_part.h"

#include <filesystem>
#include <utility>

#include "fragments/part_archive.h"

namespace linelet::apps {

namespace {

template <class Archive>
void
pass(Archive& archive, BlockPart& one_block)
{
  archive.all(one_block.block);
  CurvePart& part = one_block.curves;
  const auto plain = [&](auto& one) { archive.all(one); };
  archive.list(part.pieces, [&](CurvePiece& piece) {
    Curve& c = piece.curve;
    archive.list(c.points, plain);
    archive.list(c.support, plain);
    archive.all(c.closed, c.front, c.back, c.noise, c.density, c.evidence);
    for (CurvePiece::Cut& cut : piece.cuts) {
      archive.all(cut.neighbor);
      archive.list(cut.beyond, plain);
    }
  });
  archive.list(part.junctions, [&](Junction& junction) {
    archive.all(junction.position);
    archive.list(junction.curves, plain);
  });
}

} // namespace

void
saveBlockParts(const std::string& result, std::vector<BlockPart> parts)
{
  std::error_code ignored; // writing the file reports it
  std::filesystem::create_directories(std::filesystem::path(result).parent_path(),
                                      ignored);
  Saver saver;
  saver.list(parts, [&](BlockPart& part) { pass(saver, part); });
  saver.save(result);
}

std::vector<BlockPart>
loadBlockParts(const std::string& result)
{
  Loader loader(result);
  std::vector<BlockPart> parts;
  loader.list(parts, [&](BlockPart& part) { pass(loader, part); });
  return parts;
}

} // namespace linelet::apps
