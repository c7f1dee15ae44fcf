// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <linelet/powerline_output/output_files.h>

#include "powerline/network_by_hand.h"

namespace {

using namespace linelet;
using namespace linelet::powerline;

/** What is wrong with the nesting of tags; empty where nothing is. */
std::string
nestingError(const std::string& page)
{
  std::vector<std::string> open;
  const std::regex tag("<(/?)([A-Za-z][A-Za-z0-9]*)([^<>]*?)(/?)>");
  std::size_t brackets = 0;
  for (std::sregex_iterator it(page.begin(), page.end(), tag), end; it != end; ++it) {
    ++brackets;
    const std::string name = (*it)[2];
    if ((*it)[1] == "/") {
      if (open.empty() || open.back() != name)
        return "</" + name + "> closes " + (open.empty() ? "nothing" : open.back());
      open.pop_back();
    }
    else if ((*it)[4] != "/")
      open.push_back(name);
  }
  if (!open.empty())
    return open.back() + " is not closed";
  // Every bracket belongs to a tag or to the document type.
  const auto count =
      static_cast<std::size_t>(std::count(page.begin(), page.end(), '<'));
  return count == brackets + 1 ? "" : "a stray <";
}

std::size_t
occurrences(const std::string& text, const std::string& what)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + 1))
    ++count;
  return count;
}

class Report : public testing::Test {
protected:
  Report() : network_(test::networkByHand()), cloud_(test::cloudByHand(network_)) {}

  std::string
  page() const
  {
    return powerLineReport(cloud_, network_, options_);
  }

  PowerLineNetwork network_;
  io::Cloud cloud_;
  OutputOptions options_{"by_hand.las", 5, {}, {}, false, {}};
};

TEST_F(Report, IsWellFormedAndStandsAlone)
{
  const std::string text = page();
  EXPECT_EQ(nestingError(text), "");
  // Nothing is fetched from anywhere: links go to places of the page, pictures are
  // data.
  EXPECT_EQ(text.find("http"), std::string::npos);
  EXPECT_EQ(text.find("<script"), std::string::npos);
  const std::regex link("(href|src)=\"([^\"]{0,5})");
  for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it) {
    const std::string target = (*it)[2];
    EXPECT_TRUE(target[0] == '#' || target == "data:") << target;
  }
}

TEST_F(Report, ShowsEverySpanWithItsProfileAndWires)
{
  const std::string text = page();
  for (const Span& span : network_.spans)
    EXPECT_EQ(occurrences(text, "id=\"span" + std::to_string(span.id) + "\""), 1U);
  EXPECT_EQ(occurrences(text, "class=\"profile\""), 2U);
  EXPECT_EQ(occurrences(text, "class=\"plan\""), 1U);
  // A curve in a profile and a line in the plan for every wire.
  EXPECT_EQ(occurrences(text, "<path class=\"curve"), 3U);
  EXPECT_EQ(occurrences(text, "<path class=\"wire\""), 3U);
  for (const char* said :
       {"by_hand.las", "55 points", "P1 to P2", "P2 to P3", "0.300 km"})
    EXPECT_NE(text.find(said), std::string::npos) << said;
}

TEST_F(Report, ClearancesBelowTheLimitAreRed)
{
  const std::string text = page();
  // In the list of clearances, the table of spans and the table of wires.
  EXPECT_EQ(occurrences(text, "<td class=\"bad\">3.00</td>"), 3U);
  EXPECT_EQ(occurrences(text, "<circle class=\"hazard\""), 1U);
  EXPECT_NE(text.find("class=\"clear bad\""), std::string::npos);
  options_.clearance = 2.9;
  const std::string calm = page();
  EXPECT_EQ(occurrences(calm, "<td class=\"bad\">"), 0U);
  EXPECT_EQ(occurrences(calm, "<circle class=\"hazard\""), 0U);
  EXPECT_NE(calm.find("No wire comes closer than 2.9 m"), std::string::npos);
  // Above the wires' height over ground even that is too low.
  options_.clearance = 19;
  EXPECT_EQ(occurrences(page(), "<circle class=\"hazard\""), 3U);
}

TEST_F(Report, DoesNotCallClearWhatItDidNotFind)
{
  options_.clearance = 2.9;
  UnexplainedLine line;
  line.id = 1;
  line.course = {Point(0, 0, 10), Point(400, 0, 10)};
  line.length = 400;
  network_.unexplained.push_back(line);
  const std::string text = page();
  EXPECT_EQ(text.find("No wire comes closer"), std::string::npos);
  EXPECT_NE(text.find("400 m above ground look like lines"), std::string::npos);
}

TEST_F(Report, SaysWhyAWireIsInDoubt)
{
  const std::string text = page();
  EXPECT_NE(text.find("few points &lt; 1 a meter &amp; a hole"), std::string::npos);
  EXPECT_EQ(occurrences(text, "<path class=\"curve doubtful\""), 1U);
}

TEST_F(Report, EscapesNames)
{
  options_.source = "a<b>&\"c\".las";
  const std::string text = page();
  EXPECT_EQ(nestingError(text), "");
  EXPECT_NE(text.find("a&lt;b&gt;&amp;&quot;c&quot;.las"), std::string::npos);
}

// Nobody can get the same results again from a page that does not say how.
TEST_F(Report, SaysWithWhatItWasMade)
{
  EXPECT_EQ(page().find("id=\"settings\""), std::string::npos);
  options_.provenance = {"linelet 1.2.3",
                         "2026-11-22 09:46 UTC",
                         {"/data/tile_1.laz", "/data/tile_2.laz"},
                         {{"--max-gap", "50"}, {"--ignore-classes", "<7>"}}};
  const std::string text = page();
  EXPECT_EQ(nestingError(text), "");
  for (const char* said : {"linelet 1.2.3 · 2026-11-22 09:46 UTC",
                           "/data/tile_2.laz",
                           "<td class=\"text\">--max-gap</td>",
                           "&lt;7&gt;"})
    EXPECT_NE(text.find(said), std::string::npos) << said;
}

TEST_F(Report, WithoutWiresIsAFriendlyPage)
{
  const std::size_t n = cloud_.points.size();
  network_ = PowerLineNetwork();
  network_.classes.assign(n, 0);
  network_.wire_id.assign(n, 0);
  network_.span_id.assign(n, 0);
  network_.wire_distance.assign(n, NAN);
  const std::string text = page();
  EXPECT_EQ(nestingError(text), "");
  EXPECT_NE(text.find("No wires found"), std::string::npos);
  EXPECT_EQ(text.find("nan"), std::string::npos);
  cloud_ = io::Cloud();
  network_ = PowerLineNetwork();
  EXPECT_EQ(nestingError(page()), "");
}

TEST_F(Report, SurvivesPointsThatAreNoNumbersAndMissingGround)
{
  cloud_.points[20] = Point::Constant(NAN);
  network_.ground = Ground();
  const std::string text = page();
  EXPECT_EQ(nestingError(text), "");
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
}

} // namespace
