// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// libFuzzer harness of a LAZ chunk. The first four bytes choose point format, number of
// extra bytes, item versions and number of points; the rest is the chunk. It is either
// refused, or decoded, encoded again and decoded to the same points.

#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "io/laz/chunk_reader.h"
#include "io/laz/chunk_writer.h"

using namespace linelet::laz;

namespace {

Layout
chooseLayout(const std::uint8_t* choice)
{
  constexpr std::size_t lengths[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
  const int format = choice[0] % 11;
  Layout layout = layoutFor(format, lengths[format] + choice[1] % 9);
  const unsigned version = choice[2] % 2;
  for (Item& item : layout.items)
    item.version = format < 6 ? 1 + version : 3 + version;
  return layout;
}

void
checkRoundTrip(const Layout& layout,
               std::vector<std::uint8_t>& records,
               std::size_t count)
{
  Layout written = layout;
  for (Item& item : written.items)
    item.version = layout.layered() ? item.version : 2;
  const std::vector<std::uint8_t> chunk = writeChunk(written, records.data(), count);
  std::vector<std::uint8_t> back(records.size());
  const std::string_view text(reinterpret_cast<const char*>(chunk.data()),
                              chunk.size());
  if (readChunk(written, text, count, back.data()) != chunk.size() || back != records)
    std::abort();
}

} // namespace

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t length)
{
  if (length < 4)
    return 0;
  const Layout layout = chooseLayout(data);
  const std::size_t count = 1U + data[3] % 100U;
  const std::string_view chunk(reinterpret_cast<const char*>(data + 4), length - 4);
  std::vector<std::uint8_t> records(count * layout.recordLength());
  try {
    readChunk(layout, chunk, count, records.data());
  }
  catch (const Error&) {
    return 0;
  }
  checkRoundTrip(layout, records, count);
  return 0;
}
