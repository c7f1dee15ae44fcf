// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// The codec on its own: data comes back bit for bit, and every stream ends with its
// last point.

#include <algorithm>
#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "io/laz/bytes.h"
#include "io/laz/chunk_reader.h"
#include "io/laz/chunk_table.h"
#include "io/laz/chunk_writer.h"
#include "io/laz/decoder.h"
#include "io/laz/encoder.h"
#include "io/laz/gps_time.h"
#include "io/laz/integers.h"
#include "io/laz/median.h"

using namespace linelet::laz;

namespace {

constexpr unsigned seed = 20261122;

constexpr std::size_t lengths[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

/** Points of a scan: similar steps, values that often repeat, four channels. */
std::vector<std::uint8_t>
scan(int format, std::size_t extra, std::size_t count, std::mt19937& random)
{
  const std::size_t length = lengths[format] + extra;
  std::vector<std::uint8_t> records(count * length);
  std::vector<std::uint8_t> last(length);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t byte = 0; byte < length; ++byte)
      if (random() % 16 == 0 || i == 0)
        last[byte] = static_cast<std::uint8_t>(random());
      else if (random() % 4 == 0)
        last[byte] = static_cast<std::uint8_t>(last[byte] + random() % 3);
    std::copy(last.begin(), last.end(), &records[i * length]);
  }
  return records;
}

void
expectRoundTrip(int format, std::size_t extra, std::vector<std::uint8_t> records)
{
  const std::size_t length = lengths[format] + extra;
  const std::size_t count = records.size() / length;
  const Layout layout = layoutFor(format, length);
  const std::vector<std::uint8_t> before = records;
  const std::vector<std::uint8_t> coded = writeChunk(layout, records.data(), count);
  EXPECT_EQ(before, records) << "encoding must not change the records";
  const std::string_view text(reinterpret_cast<const char*>(coded.data()),
                              coded.size());
  std::vector<std::uint8_t> back(records.size());
  EXPECT_EQ(readChunk(layout, text, count, back.data()), coded.size());
  EXPECT_TRUE(back == records);
  EXPECT_EQ(skipChunk(layout, text, count), coded.size());
}

} // namespace

TEST(LazCodec, IntegersOfEverySizeRoundTrip)
{
  std::vector<std::uint32_t> values = {
      0, 1, ~0U, 0x7FFFFFFFU, 0x80000000U, 0x80000001U};
  for (unsigned bit = 0; bit < 32; ++bit)
    for (int off = -2; off <= 2; ++off)
      values.push_back((1U << bit) + static_cast<unsigned>(off));
  Encoder encoder;
  IntegerModel<32, 2> out;
  std::uint32_t last = 0;
  for (const std::uint32_t value : values) {
    out.code(encoder, last, value, value & 1U);
    last = value;
  }
  const auto bytes = encoder.finish();
  Decoder decoder(bytes.data(), bytes.data() + bytes.size());
  IntegerModel<32, 2> in;
  last = 0;
  for (const std::uint32_t value : values)
    ASSERT_EQ(last = in.code(decoder, last, 0, value & 1U), value);
  EXPECT_FALSE(decoder.overrun());
  EXPECT_EQ(decoder.next(), bytes.data() + bytes.size());
}

TEST(LazCodec, ModelsFindTheSymbolWhoseIntervalHoldsTheTarget)
{
  std::mt19937 random(seed);
  SymbolModel<256> model(200);
  for (int i = 0; i < 5000; ++i) {
    const std::uint32_t target = random() % 0x8000;
    unsigned expected = 0; // the definition
    while (expected + 1 < 200 && model.low(expected + 1) <= target)
      ++expected;
    ASSERT_EQ(model.find(target), expected);
    model.count(static_cast<unsigned>(random() % 200 * (random() % 2)));
  }
}

TEST(LazCodec, MedianOfManyEqualStepsIsThatStep)
{
  RunningMedian median;
  for (int i = 0; i < 10; ++i)
    median.add(i % 2 == 0 ? 7 : 7);
  EXPECT_EQ(median.get(), 7);
  median.add(1000);
  EXPECT_EQ(median.get(), 7) << "one outlier does not move the median";
}

TEST(LazCodec, TimesOfSeveralSequencesRoundTrip)
{
  std::mt19937_64 random(seed);
  std::vector<std::uint64_t> times = {0, ~std::uint64_t{0}, 1};
  std::uint64_t lines[5] = {1ULL << 60, 1ULL << 50, 3, 1ULL << 61, 1ULL << 40};
  for (int i = 0; i < 3000; ++i) {
    std::uint64_t& line = lines[random() % 40 == 0 ? random() % 5 : 1];
    line += random() % 10 == 0 ? random() % 100000 - 5000 : 97 * (random() % 12);
    times.push_back(line);
  }
  Encoder encoder;
  GpsTimeModel<true> out(5);
  for (const std::uint64_t time : times)
    out.code(encoder, time);
  const auto bytes = encoder.finish();
  Decoder decoder(bytes.data(), bytes.data() + bytes.size());
  GpsTimeModel<true> in(5);
  for (const std::uint64_t time : times)
    ASSERT_EQ(in.code(decoder), time);
}

TEST(LazCodec, ChunksOfEveryFormatRoundTripBitForBit)
{
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  for (int format = 0; format <= 10; ++format)
    for (const std::size_t extra : {0, 1, 7})
      for (const std::size_t count : {1, 2, 3, 700}) {
        SCOPED_TRACE("format " + std::to_string(format) + ", " + std::to_string(extra) +
                     " extra bytes, " + std::to_string(count) + " points");
        expectRoundTrip(format, extra, scan(format, extra, count, random));
      }
}

TEST(LazCodec, ConstantAndRandomPointsRoundTrip)
{
  std::mt19937 random(seed);
  for (int format = 0; format <= 10; ++format) {
    std::vector<std::uint8_t> records(lengths[format] * 1000, 0x5A);
    expectRoundTrip(format, 0, records);
    for (std::uint8_t& byte : records)
      byte = static_cast<std::uint8_t>(random());
    expectRoundTrip(format, 0, records);
  }
}

TEST(LazCodec, SkippedLayersKeepTheValuesOfTheFirstPoint)
{
  std::mt19937 random(seed);
  const Layout layout = layoutFor(7, 36);
  std::vector<std::uint8_t> records = scan(7, 0, 500, random);
  const auto coded = writeChunk(layout, records.data(), 500);
  const std::string_view text(reinterpret_cast<const char*>(coded.data()),
                              coded.size());
  std::vector<std::uint8_t> back(records.size());
  readChunk(layout, text, 500, back.data(), field::z | field::classification);
  for (std::size_t i = 0; i < 500; ++i) {
    EXPECT_EQ(std::memcmp(&back[36 * i], &records[36 * i], 12), 0) << "x, y, z";
    EXPECT_EQ(back[36 * i + 14], records[36 * i + 14]) << "returns";
    EXPECT_EQ(back[36 * i + 16], records[36 * i + 16]) << "class";
    EXPECT_EQ(back[36 * i + 12], records[12]) << "intensity";
    EXPECT_EQ(back[36 * i + 30], records[30]) << "red";
  }
}

TEST(LazCodec, TruncatedDataAreRefusedAtAnyLength)
{
  std::mt19937 random(seed);
  for (const int format : {1, 7}) {
    const Layout layout = layoutFor(format, lengths[format]);
    std::vector<std::uint8_t> records = scan(format, 0, 40, random);
    const auto coded = writeChunk(layout, records.data(), 40);
    std::vector<std::uint8_t> back(records.size());
    for (std::size_t size = 0; size < coded.size(); ++size)
      EXPECT_THROW(readChunk(layout,
                             {reinterpret_cast<const char*>(coded.data()), size},
                             40,
                             back.data()),
                   Error);
  }
}

TEST(LazCodec, AChunkTableBoundsItsChunksByTheFile)
{
  const Layout layout = layoutFor(0, 20);
  std::vector<std::uint8_t> records(20 * 10);
  const auto chunk = writeChunk(layout, records.data(), 10);
  const auto table = writeChunkTable({static_cast<std::uint32_t>(chunk.size())});
  std::string file(8, '\0');
  file.append(chunk.begin(), chunk.end());
  file[0] = static_cast<char>(file.size());
  file.append(table.begin(), table.end());
  EXPECT_EQ(readChunkTable(file, 0, 10, layout).points, 10U);
  EXPECT_TRUE(readChunkTable(file, 0, 0, layout).chunks.empty());
  // More points than the data can hold.
  EXPECT_ANY_THROW(readChunkTable(file, 0, 40000, layout));
  for (std::size_t i = 0; i < file.size(); ++i)
    for (const int bit : {0, 3, 7}) {
      std::string bad = file;
      bad[i] = static_cast<char>(bad[i] ^ 1 << bit);
      try {
        for (const Chunk& c : readChunkTable(bad, 0, 10, layout).chunks) {
          EXPECT_LE(c.at + c.bytes, bad.size());
          EXPECT_LE(c.count, 10U);
        }
      }
      catch (const Error&) {
      }
    }
}

TEST(LazCodec, ItemListsAreCheckedBeforeDecoding)
{
  const std::string good = textOf(layoutFor(7, 40));
  EXPECT_EQ(parseLayout(good, 7, 40).recordLength(), 40U);
  EXPECT_THROW(parseLayout(good, 6, 40), Error);
  EXPECT_THROW(parseLayout(good, 7, 41), Error);
  EXPECT_THROW(parseLayout(good, 1, 40), Error);
  for (std::size_t size = 0; size < good.size(); ++size)
    EXPECT_THROW(parseLayout(good.substr(0, size), 7, 40), Error);
  std::string version5 = good;
  version5[34 + 4] = 5;
  EXPECT_THROW(parseLayout(version5, 7, 40), Error);
}
