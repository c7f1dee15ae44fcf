// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <regex>
#include <string>
#include <vector>

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <nlohmann/json.hpp>

#include "report_page.h"

namespace linelet::test {

using namespace powerline;

namespace {

TEST_F(Report, IsWellFormedAndStandsAlone)
{
  const std::string text = page();
  EXPECT_EQ(nestingError(text), "");
  // The page loads nothing: links stay within the page, pictures are embedded.
  EXPECT_EQ(text.find("http"), std::string::npos);
  EXPECT_EQ(text.find("<script src"), std::string::npos); // none from elsewhere
  EXPECT_EQ(text.find("import("), std::string::npos);
  EXPECT_EQ(text.find("fetch("), std::string::npos);
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

// As GDAL reads it: as wide and high as drawn, darkest where the highest tree stands.
TEST_F(Report, PlanShowsHeightsAboveGround)
{
  const std::string text = page();
  const std::regex image("<image [^>]*width=\"([0-9.]+)\" height=\"([0-9.]+)\"[^>]*"
                         "data:image/png;base64,([A-Za-z0-9+/=]+)\"");
  std::smatch match;
  ASSERT_TRUE(std::regex_search(text, match, image));
  std::string png = match[3];
  auto* bytes = reinterpret_cast<GByte*>(png.data());
  const int size = CPLBase64DecodeInPlace(bytes);
  const char* path = "/vsimem/plan.png";
  VSIFCloseL(VSIFileFromMemBuffer(path, bytes, static_cast<vsi_l_offset>(size), FALSE));
  const GDALDatasetUniquePtr plan(GDALDataset::Open(path, GDAL_OF_RASTER));
  ASSERT_TRUE(plan);
  const int columns = plan->GetRasterXSize(), rows = plan->GetRasterYSize();
  EXPECT_NEAR(std::stod(match[1]) / std::stod(match[2]),
              static_cast<double>(columns) / rows,
              0.01);
  std::vector<GByte> pixels(static_cast<std::size_t>(columns) *
                            static_cast<std::size_t>(rows));
  ASSERT_EQ(
      plan->GetRasterBand(1)->RasterIO(
          GF_Read, 0, 0, columns, rows, pixels.data(), columns, rows, GDT_Byte, 0, 0),
      CE_None);
  const Point tree = network_.wires[1].vegetation.other;
  const double height = tree.z() - network_.ground.heightAt(tree.x(), tree.y());
  const int darkest = *std::max_element(pixels.begin(), pixels.end());
  EXPECT_EQ(darkest, 1 + std::clamp(static_cast<int>(height), 0, 23));
  const GDALColorTable* colors = plan->GetRasterBand(1)->GetColorTable();
  ASSERT_NE(colors, nullptr);
  EXPECT_EQ(colors->GetColorEntry(0)->c2, 255); // nothing: white
  EXPECT_LT(colors->GetColorEntry(darkest)->c1, colors->GetColorEntry(darkest)->c2);
}

TEST_F(Report, ClearancesBelowTheLimitAreRed)
{
  const std::string text = page();
  // In the list of clearances, the table of spans and the table of wires.
  EXPECT_EQ(occurrences(text, "<td class=\"bad\">3.00</td>"), 2U);
  EXPECT_EQ(occurrences(text, "<td class=\"bad\"><a href=\"#space-1\">3.00</a></td>"),
            1U);
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

TEST_F(Report, DoesNotCallClearWhatWasNotFound)
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

// A scan of only the line shows no hazards, which does not prove that there are none.
TEST_F(Report, UnknownClearancesAreNotReportedAsSafe)
{
  const std::string known = page();
  EXPECT_EQ(known.find("clearances are unknown"), std::string::npos);
  for (Wire& wire : network_.wires)
    wire.ground = wire.vegetation = Clearance();
  std::string text = page();
  EXPECT_EQ(nestingError(text), "");
  EXPECT_EQ(text.find("No wire comes closer"), std::string::npos);
  EXPECT_NE(text.find("clearances are unknown"), std::string::npos);
  options_.hazards.emplace_back();
  text = page();
  EXPECT_EQ(nestingError(text), "");
  EXPECT_EQ(text.find("Nothing is closer"), std::string::npos);
  EXPECT_EQ(text.find("No wire comes closer"), std::string::npos);
  EXPECT_NE(text.find("Clearances are unknown"), std::string::npos);
}

/** Decodes base64 text. */
std::vector<std::uint8_t>
decoded(const std::string& text)
{
  std::vector<std::uint8_t> bytes;
  unsigned word = 0, bits = 0;
  for (const char c : text) {
    if (c == '=')
      break;
    const auto digit =
        std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                    "0123456789+/")
            .find(c);
    word = word << 6 | static_cast<unsigned>(digit);
    bits += 6;
    if (bits >= 8) {
      bits -= 8;
      bytes.push_back(static_cast<std::uint8_t>(word >> bits));
    }
  }
  return bytes;
}

// The 3D view draws every point of this small cloud, every wire, and each hazard under
// the number that the table links to.
TEST_F(Report, ViewInSpaceHoldsCloudWiresAndHazards)
{
  const std::string text = page();
  const std::string lead = "<script type=\"application/json\" id=\"space-data\">";
  const std::size_t begin = text.find(lead);
  ASSERT_NE(begin, std::string::npos);
  const std::size_t from = begin + lead.size();
  const auto data =
      nlohmann::json::parse(text.substr(from, text.find("</script>", from) - from));
  const std::vector<std::uint8_t> places = decoded(data["places"]),
                                  looks = decoded(data["looks"]),
                                  lines = decoded(data["lines"]);
  ASSERT_EQ(places.size(), 6 * cloud_.points.size());
  EXPECT_EQ(looks.size(), cloud_.points.size());
  EXPECT_EQ(std::count(looks.begin(), looks.end(), 4), 12); // points of wires
  const double step = data["step"];
  const auto coordinate = [&](std::size_t i, std::size_t axis) {
    return step * (places[6 * i + 2 * axis] + 256 * places[6 * i + 2 * axis + 1]);
  };
  // Points off the lines come first, in order; ground begins at x = 0.
  double low = 1e9;
  for (const Point& p : cloud_.points)
    low = std::min(low, p.y());
  for (std::size_t k = 0; k < 40; ++k) {
    EXPECT_NEAR(coordinate(2 + k, 0), cloud_.points[15 + k].x(), step);
    EXPECT_NEAR(coordinate(2 + k, 1), cloud_.points[15 + k].y() - low, step);
  }
  std::size_t runs = 0;
  for (std::size_t at = 0; at < lines.size(); ++runs)
    at += 4 + 6 * (lines[at] + 256U * lines[at + 1]);
  EXPECT_EQ(runs, 3U);
  ASSERT_EQ(data["hazards"].size(), 1U);
  EXPECT_EQ(occurrences(text, "id=\"space-1\""), 1U);
  EXPECT_NE(data["hazards"][0]["text"].get<std::string>().find("3.00 m to object"),
            std::string::npos);
  // Without WebGL 2, a picture.
  EXPECT_EQ(occurrences(text, "<svg class=\"still\""), 1U);
}

// A jumper is a line of its own kind in the 3D view and beside its support in both
// profiles; points of insulators have their own color.
TEST_F(Report, JumpersAndInsulatorsAreDrawn)
{
  const std::string before = page();
  EXPECT_EQ(occurrences(before, "class=\"jumper\""), 0U);
  Jumper jumper;
  jumper.id = 1;
  jumper.support = 2;
  jumper.from_wire = 1;
  jumper.to_wire = 3;
  jumper.course = {{98, 3, 20}, {100, 3, 18}, {102, 3, 20}};
  network_.jumpers.push_back(jumper);
  network_.classes[12] = connector_class; // a pylon's point before
  const std::string text = page();
  EXPECT_EQ(occurrences(text, "class=\"jumper\""), 3U); // two profiles, the still
  const std::string lead = "id=\"space-data\">";
  const std::size_t from = text.find(lead) + lead.size();
  const auto data =
      nlohmann::json::parse(text.substr(from, text.find("</script>", from) - from));
  const std::vector<std::uint8_t> looks = decoded(data["looks"]),
                                  lines = decoded(data["lines"]);
  EXPECT_EQ(std::count(looks.begin(), looks.end(), 3), 0);
  EXPECT_EQ(std::count(looks.begin(), looks.end(), 5), 1);
  std::vector<int> kinds;
  for (std::size_t at = 0; at < lines.size();
       at += 4 + 6 * (lines[at] + 256U * lines[at + 1]))
    kinds.push_back(lines[at + 2]);
  EXPECT_EQ(kinds, (std::vector<int>{0, 1, 0, 2})); // the second wire is doubtful
}

TEST_F(Report, GivesTheReasonForDoubt)
{
  const std::string text = page();
  EXPECT_NE(text.find("few points &lt; 1 per meter &amp; a hole"), std::string::npos);
  EXPECT_EQ(occurrences(text, "<path class=\"curve doubtful\""), 1U);
}

TEST_F(Report, EscapesNames)
{
  options_.source = "a<b>&\"c\".las";
  const std::string text = page();
  EXPECT_EQ(nestingError(text), "");
  EXPECT_NE(text.find("a&lt;b&gt;&amp;&quot;c&quot;.las"), std::string::npos);
}

// Results cannot be reproduced from a page without the settings.
TEST_F(Report, NamesProgramInputsAndSettings)
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

TEST_F(Report, WithoutWiresIsAHelpfulPage)
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

TEST_F(Report, SurvivesNonFinitePointsAndMissingGround)
{
  cloud_.points[20] = Point::Constant(NAN);
  network_.ground = Ground();
  const std::string text = page();
  EXPECT_EQ(nestingError(text), "");
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("inf"), std::string::npos);
}

} // namespace

} // namespace linelet::test
