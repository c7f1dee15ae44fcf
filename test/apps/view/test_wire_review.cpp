// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "model_test.h"

#include <linelet/powerline_output/output_files.h>

#include "powerline/network_by_hand.h"

namespace {

using namespace linelet;
using namespace linelet::view;
using powerline::Review;
using Verdict = powerline::Review::Verdict;

class WireReviewTest : public linelet::test::ModelTest {
protected:
  WireReviewTest() : network(test::networkByHand()), cloud(test::cloudByHand(network))
  {
    powerline::writePowerLineFiles(path("out"), cloud, network);
    open(path("out"));
  }

  powerline::PowerLineNetwork network;
  io::Cloud cloud;
};

// The folder's files agree with what was found to a tenth of a millimeter.
TEST_F(WireReviewTest, FolderIsReadBack)
{
  ASSERT_NE(model.lines(), nullptr);
  const powerline::PowerLineNetwork& read = *model.lines();
  ASSERT_EQ(read.wires.size(), network.wires.size());
  const Point origin = model.scene().cloud.shift - cloud.shift;
  for (std::size_t i = 0; i < read.wires.size(); ++i) {
    const powerline::Wire &a = read.wires[i], &b = network.wires[i];
    EXPECT_NEAR((a.front + origin - b.front).norm(), 0, 2e-4);
    EXPECT_NEAR(
        (a.curve.at(0.3 * a.curve.to) + origin - b.curve.at(0.3 * b.curve.to)).norm(),
        0,
        2e-3);
    EXPECT_EQ(a.reason, b.reason);
    EXPECT_NEAR(a.confidence, b.confidence, 1e-4);
    EXPECT_EQ(a.vegetation.known(), b.vegetation.known());
  }
  EXPECT_EQ(read.wire_id, network.wire_id);
  EXPECT_EQ(read.spans[0].wires, network.spans[0].wires);
  EXPECT_EQ(read.circuits[0].supports, network.circuits[0].supports);
}

TEST_F(WireReviewTest, TheLeastCertainComesFirst)
{
  EXPECT_EQ(model.wiresByConfidence(), (std::vector<int>{2, 1, 3}));
}

// Nothing is saved at exit, so that a crash loses nothing.
TEST_F(WireReviewTest, EveryWordIsSavedAtOnce)
{
  model.setReview(2, {Verdict::Rejected, -1, "a fence"});
  model.setReview(3, {Verdict::Accepted, 13, ""});
  Model after; // another program; this one never closed anything
  after.open({path("out")});
  EXPECT_EQ(after.wait().error, "");
  EXPECT_TRUE(after.review(1).empty());
  EXPECT_EQ(after.review(2).verdict, Verdict::Rejected);
  EXPECT_EQ(after.review(2).note, "a fence");
  EXPECT_EQ(after.review(3).verdict, Verdict::Accepted);
  EXPECT_EQ(after.review(3).point_class, 13);
}

TEST_F(WireReviewTest, InvalidReviewsAreRefused)
{
  EXPECT_THROW(model.setReview(0, {}), std::invalid_argument);
  EXPECT_THROW(model.setReview(4, {}), std::invalid_argument);
  EXPECT_THROW(model.setReview(1, {Verdict::None, 256, ""}), std::invalid_argument);
  EXPECT_THROW(model.selectWire(4), std::invalid_argument);
}

// A broken review next to intact results: the error is reported, the results are shown.
TEST_F(WireReviewTest, ABrokenReviewIsReported)
{
  write("out/reviewed.gpkg", "no database");
  model.open({path("out")});
  EXPECT_NE(model.wait().error.find("reviewed.gpkg"), std::string::npos);
  EXPECT_EQ(model.lines()->wires.size(), 3u);
}

TEST_F(WireReviewTest, ABrokenSummaryIsReported)
{
  for (const char* text : {"", "{", "[]", "{\"wires\":[{}]}"}) {
    write("out/summary.json", text);
    model.open({path("out")});
    EXPECT_NE(model.wait().error.find("summary.json"), std::string::npos) << text;
  }
}

} // namespace
