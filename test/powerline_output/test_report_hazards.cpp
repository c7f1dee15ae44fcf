// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <linelet/powerline_output/power_line_summary.h>

#include "report_page.h"

namespace linelet::test {

using namespace powerline;

namespace {

/** Two stretches, a tree and a crossing along the hand-made line. */
std::vector<Hazards>
hazardsByHand(const PowerLineNetwork& network)
{
  Hazards hazards;
  hazards.state = "as scanned";
  hazards.limits = uniformLimits(5);
  const auto add = [&](int wire, Severity severity, HazardKind kind, double distance) {
    Encroachment one;
    one.id = static_cast<int>(hazards.clearances.size()) + 1;
    one.kind = kind;
    one.severity = severity;
    one.wire = wire;
    one.span = network.wires[static_cast<std::size_t>(wire) - 1].span;
    const Catenary& curve = network.wires[static_cast<std::size_t>(wire) - 1].curve;
    one.line = {curve.at(-5), curve.at(0), curve.at(5)};
    one.nearest = {distance, curve.at(0), curve.at(0) - Point(0, 0, distance)};
    one.vertical = distance;
    one.length = 10;
    one.outline = {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 0, 0)};
    one.area = kind == HazardKind::Vegetation ? 12.5 : 0;
    one.volume = kind == HazardKind::Vegetation ? 30 : 0;
    hazards.clearances.push_back(one);
  };
  add(1, Severity::Low, HazardKind::Ground, 4.5);
  add(2, Severity::High, HazardKind::Vegetation, 2.25);
  FallIn tree;
  tree.id = 1;
  tree.severity = Severity::High;
  tree.wire = 3;
  tree.span = 2;
  tree.top = Point(150, 12, 21);
  tree.height = 21;
  tree.distance = 20.5;
  tree.gap = -0.5;
  hazards.fall_in.push_back(tree);
  Crossing crossing;
  crossing.id = 1;
  crossing.upper = 1;
  crossing.lower = 3;
  crossing.vertical = 6;
  crossing.nearest = {5.9, Point(50, 3, 18), Point(50, 3, 12)};
  hazards.crossings.push_back(crossing);
  return {hazards};
}

// Every hazard has a row that the plan and the profile link to, and the first lines of
// the page say what is severe and where.
TEST_F(Report, HazardsAreSummarizedListedAndMarked)
{
  options_.hazards = hazardsByHand(network_);
  const std::string text = page();
  EXPECT_EQ(nestingError(text), "");
  EXPECT_NE(text.find("Act now: severe hazards in span 1."), std::string::npos);
  for (const char* id :
       {"hazard1", "hazard2", "plan1", "plan2", "tree1", "plantree1", "crossing1"})
    EXPECT_EQ(occurrences(text, "id=\"" + std::string(id) + "\""), 1U) << id;
  EXPECT_EQ(occurrences(text, "href=\"#hazard2\""), 2U); // from plan and profile
  EXPECT_LT(text.find("id=\"hazard2\""), text.find("id=\"hazard1\"")); // severe first
  EXPECT_NE(text.find("12.5"), std::string::npos);
  EXPECT_EQ(text.find("No wire comes closer"), std::string::npos);
  options_.hazards.front().clearances.clear();
  options_.hazards.front().fall_in.clear();
  const std::string calm = page();
  EXPECT_NE(calm.find("Nothing is closer to a wire than its limit"), std::string::npos);
}

TEST_F(Report, OtherStatesHaveTheirOwnRows)
{
  options_.hazards = hazardsByHand(network_);
  Hazards hot = options_.hazards.front();
  hot.state = "75C";
  for (Encroachment& one : hot.clearances)
    one.id += 2;
  hot.fall_in.clear();
  hot.crossings.clear();
  hot.moved.wires = network_.wires;
  hot.moved.sections.push_back({1, {1, 3}, 100, 20000, 17500});
  options_.hazards.push_back(hot);
  const std::string text = page();
  EXPECT_EQ(nestingError(text), "");
  for (const char* said : {"At 75C", "id=\"hazard3\"", "id=\"states\"", "17.50"})
    EXPECT_NE(text.find(said), std::string::npos) << said;
}

// The plan shows unexplained lines, and the hazards.
TEST_F(Report, WhatWasNotExplainedIsInThePlan)
{
  options_.hazards = hazardsByHand(network_);
  UnexplainedLine line;
  line.id = 7;
  line.course = {Point(20, 20, 9), Point(80, 30, 9)};
  line.length = 61;
  network_.unexplained.push_back(line);
  const std::string text = page();
  EXPECT_EQ(nestingError(text), "");
  EXPECT_EQ(occurrences(text, "<path class=\"unexplained\""), 1U);
  EXPECT_NE(text.find("61 m look like lines"), std::string::npos);
}

// A reader of the summary would look for a wire or support 0.
TEST_F(Report, SummaryOfAHazardOfNoOtherWireSaysNull)
{
  options_.hazards = hazardsByHand(network_);
  options_.hazards.front().clearances.back().other = 2;
  const auto summary =
      nlohmann::json::parse(powerLineSummary(cloud_, network_, options_));
  const auto& listed = summary["hazards"][0]["clearances"];
  ASSERT_EQ(listed.size(), 2U);
  EXPECT_TRUE(listed[0]["other_id"].is_null());
  EXPECT_EQ(listed[1]["other_id"], 2);
  EXPECT_EQ(listed[0]["wire_id"], 1);
}

} // namespace

} // namespace linelet::test
