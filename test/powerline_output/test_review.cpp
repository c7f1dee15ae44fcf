// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include <linelet/io/file_error.h>
#include <linelet/io/vector_file.h>
#include <linelet/powerline_output/review_file.h>

#include "powerline/network_by_hand.h"

namespace {

using namespace linelet;
using namespace linelet::powerline;
using Verdict = Review::Verdict;

class ReviewTest : public testing::Test {
protected:
  ReviewTest()
      : network(test::networkByHand()),
        cloud(test::cloudByHand(network)),
        path((std::filesystem::temp_directory_path() /
              ("linelet_review_" + std::to_string(getpid()) + ".gpkg"))
                 .string())
  {
  }
  ~ReviewTest() override { std::filesystem::remove(path); }

  std::vector<ReviewedWire>
  saved()
  {
    writeReview(path, cloud, network);
    return readReview(path, cloud);
  }

  PowerLineNetwork network;
  io::Cloud cloud;
  std::string path;
};

// An empty review changes nothing, not even a number.
TEST_F(ReviewTest, SilenceChangesNothing)
{
  PowerLineNetwork again = network;
  EXPECT_TRUE(applyReview(again, saved()).empty());
  ASSERT_EQ(again.wires.size(), network.wires.size());
  for (std::size_t i = 0; i < again.wires.size(); ++i) {
    EXPECT_EQ(again.wires[i].id, network.wires[i].id);
    EXPECT_EQ(again.wires[i].span, network.wires[i].span);
    EXPECT_EQ(again.wires[i].confidence, network.wires[i].confidence);
  }
  EXPECT_EQ(again.wire_id, network.wire_id);
  EXPECT_EQ(again.span_id, network.span_id);
  EXPECT_EQ(again.classes, network.classes);
  EXPECT_EQ(again.circuits.front().spans, network.circuits.front().spans);
}

// Reviews are read back from the file word for word.
TEST_F(ReviewTest, FileKeepsEveryWord)
{
  network.wires[0].review = {Verdict::Accepted, 13, "earth wire, \"seen\" on site; ü"};
  network.wires[2].review.verdict = Verdict::Rejected;
  const auto read = saved();
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(read[0].review.verdict, Verdict::Accepted);
  EXPECT_EQ(read[0].review.point_class, 13);
  EXPECT_EQ(read[0].review.note, "earth wire, \"seen\" on site; ü");
  EXPECT_TRUE(read[1].review.empty());
  EXPECT_EQ(read[2].review.verdict, Verdict::Rejected);
  EXPECT_NEAR((read[0].vertices.front() - network.wires[0].front).norm(), 0, 1e-6);
}

// Rejecting a wire leaves points, span and numbering consistent; its neighbors keep
// theirs.
TEST_F(ReviewTest, RejectedWireLeavesNothing)
{
  network.wires[0].review.verdict = Verdict::Rejected;
  PowerLineNetwork after = network;
  applyReview(after, saved());
  ASSERT_EQ(after.wires.size(), 2u);
  EXPECT_EQ(after.wires[0].id, 1);
  EXPECT_EQ(after.wires[0].curve.lowest, network.wires[1].curve.lowest);
  EXPECT_EQ(after.spans[0].wires, std::vector<int>{1});
  EXPECT_EQ(after.spans[1].wires, std::vector<int>{2});
  for (std::size_t i = 0; i < network.wire_id.size(); ++i) {
    const int before = network.wire_id[i];
    EXPECT_EQ(after.wire_id[i], before <= 1 ? 0 : before - 1) << i;
    EXPECT_EQ(after.classes[i], before == 1 ? unclassified : network.classes[i]) << i;
    EXPECT_EQ(after.span_id[i], before == 1 ? 0 : network.span_id[i]) << i;
  }
}

// The only wire of a span: the span disappears, and so does a support without points.
TEST_F(ReviewTest, EmptySpansGo)
{
  network.wires[2].review.verdict = Verdict::Rejected;
  PowerLineNetwork after = network;
  applyReview(after, saved());
  ASSERT_EQ(after.spans.size(), 1u);
  ASSERT_EQ(after.circuits.size(), 1u);
  EXPECT_EQ(after.circuits[0].spans, std::vector<int>{1});
  EXPECT_EQ(after.circuits[0].supports, (std::vector<int>{1, 2}));
  EXPECT_EQ(after.supports.size(), 2u);
}

// With every wire rejected, the network is that of a cloud without wires.
TEST_F(ReviewTest, AllRejected)
{
  for (Wire& wire : network.wires)
    wire.review.verdict = Verdict::Rejected;
  PowerLineNetwork after = network;
  applyReview(after, saved());
  EXPECT_TRUE(after.wires.empty());
  EXPECT_TRUE(after.spans.empty());
  EXPECT_TRUE(after.circuits.empty());
  ASSERT_EQ(after.supports.size(), 1u); // it has its own point
  EXPECT_EQ(after.supports[0].id, 1);
}

TEST_F(ReviewTest, AcceptedWireIsCertain)
{
  network.wires[1].review = {Verdict::Accepted, -1, "checked"};
  PowerLineNetwork after = network;
  EXPECT_TRUE(applyReview(after, saved()).empty());
  EXPECT_EQ(after.wires[1].confidence, 1);
  EXPECT_EQ(after.wires[1].reason, "");
  EXPECT_EQ(after.wires[1].review.note, "checked");
}

// Other settings give other ids and ends, so a wire is identified by its position.
TEST_F(ReviewTest, WiresAreKnownByTheirPlace)
{
  network.wires[0].review.note = "left";
  network.wires[1].review.note = "right";
  const auto reviewed = saved();
  PowerLineNetwork other = network;
  std::swap(other.wires[0], other.wires[1]);
  other.wires[0].curve.from += 20; // a shorter piece of it
  other.wires[0].length -= 20;
  EXPECT_EQ(matchReviewed(other, reviewed)[0], 1);
  EXPECT_EQ(matchReviewed(other, reviewed)[1], 0);
  // The next conductor of a bundle, 0.4 m away, is another wire.
  other.wires[0].curve.lowest += Point(0, 0.4, 0);
  EXPECT_EQ(matchReviewed(other, reviewed)[0], -1);
}

TEST_F(ReviewTest, AnAcceptedWireThatIsNotFoundIsReported)
{
  network.wires[2].review.verdict = Verdict::Accepted;
  const auto reviewed = saved();
  PowerLineNetwork other = network;
  other.wires[2].curve.lowest.z() += 5;
  ASSERT_EQ(applyReview(other, reviewed).size(), 1u);
}

// Another class for the points of one wire, the standard one for the rest.
TEST_F(ReviewTest, ClassOfTheReviewReachesThePoints)
{
  network.wires[1].review.point_class = 13;
  classify(cloud, network);
  const io::Column* classes = cloud.find("classification");
  for (std::size_t i = 0; i < 12; ++i)
    EXPECT_EQ(io::valueAt(*classes, i), network.wire_id[i] == 2 ? 13 : 14) << i;
}

TEST_F(ReviewTest, OtherFilesAreRefused)
{
  io::VectorLayer layer;
  layer.name = "lines";
  layer.features.push_back({{Point(0, 0, 0), Point(1, 0, 0)}, {}, "", ""});
  io::writeLayers(path, {layer}, "");
  EXPECT_THROW(readReview(path, cloud), io::FileError);
  layer.features[0].attributes = {{"review", std::string("perhaps")}};
  io::writeLayers(path, {layer}, "");
  EXPECT_THROW(readReview(path, cloud), io::FileError);
}

} // namespace
