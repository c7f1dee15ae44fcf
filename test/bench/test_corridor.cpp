// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <bench/measures/segment_tree.h>
#include <bench/scenes/corridor.h>
#include <linelet/io/point_file.h>
#include <linelet/io/vector_file.h>

namespace {

using namespace linelet;
using namespace linelet::bench;

/** Small enough to simulate in a tenth of a second. */
CorridorSettings
smallScene(std::uint32_t seed)
{
  CorridorSettings s;
  s.seed = seed;
  s.length = 260;
  s.width = 60;
  s.density = 6;
  return s;
}

std::map<int, std::size_t>
classCounts(const CorridorScan& scan)
{
  std::map<int, std::size_t> counts;
  for (const std::uint8_t c : scan.classification)
    ++counts[c];
  return counts;
}

double
arcLength(const Points& line)
{
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    sum += (line[i] - line[i - 1]).norm();
  return sum;
}

/** Constant of the catenary with horizontal span \a l, rise \a h and arc length \a arc:
 * 2 a sinh(l / 2a) = sqrt(arc^2 - h^2), whose left side falls with a. */
double
constantOf(double l, double h, double arc)
{
  const double target = std::sqrt(arc * arc - h * h);
  double low = 50, high = 1e5;
  for (int i = 0; i < 200; ++i) {
    const double a = 0.5 * (low + high);
    (2 * a * std::sinh(l / (2 * a)) > target ? low : high) = a;
  }
  return low;
}

TEST(Corridor, SameSettingsGiveTheSameScan)
{
  const CorridorScan one = simulateCorridor(smallScene(3));
  const CorridorScan two = simulateCorridor(smallScene(3));
  ASSERT_EQ(one.points.size(), two.points.size());
  EXPECT_EQ(one.points, two.points);
  EXPECT_EQ(one.intensity, two.intensity);
  EXPECT_EQ(one.classification, two.classification);
  EXPECT_EQ(one.shift, two.shift);
  const CorridorScan other = simulateCorridor(smallScene(4));
  EXPECT_NE(one.shift, other.shift);
  EXPECT_NE(one.points.size(), other.points.size());
}

TEST(Corridor, BundledSceneIsMadeByTheCommandThatItsReadmeNames)
{
  CorridorSettings s;
  s.length = 400;
  s.width = 60;
  s.density = 16;
  s.divergence = 0.6;
  s.thin_ground = 12;
  s.seed = 23;
  const CorridorScan scan = simulateCorridor(s);
  const std::string folder = std::string(LINELET_SOURCE_DIR) + "/data/";
  const io::Cloud file = io::readCloud(folder + "corridor.las");
  ASSERT_EQ(file.points.size(), scan.points.size());
  const io::Column* classes = file.find("classification");
  ASSERT_NE(classes, nullptr);
  const Point offset = scan.shift - file.shift;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    ASSERT_LT((scan.points[i] + offset - file.points[i]).cwiseAbs().maxCoeff(), 1e-6)
        << "point " << i;
    ASSERT_EQ(io::valueAt(*classes, i), scan.classification[i]) << "point " << i;
  }
  const CurveNetwork truth = io::readCurves(folder + "corridor.truth.obj", scan.shift);
  ASSERT_EQ(truth.curves.size(), scan.wires.size());
  for (std::size_t w = 0; w < scan.wires.size(); ++w)
    EXPECT_NEAR(
        arcLength(truth.curves[w].points), arcLength(scan.wires[w].points), 1e-6);
}

TEST(Corridor, WiresHangAsCatenariesOfTheGivenConstant)
{
  CorridorSettings s = smallScene(5);
  s.length = 600;
  s.density = 0.5;
  s.catenary = 900;
  int whole = 0;
  for (const CorridorWire& wire : simulateCorridor(s).wires) {
    if (!wire.front_attached || !wire.back_attached ||
        wire.kind == WireKind::LowVoltage)
      continue;
    ++whole;
    const Point from = wire.points.front(), to = wire.points.back();
    const double l = (to - from).head<2>().norm(), h = to.z() - from.z();
    // The polyline cuts its corners by a few parts in ten million.
    const double a = constantOf(l, h, arcLength(wire.points));
    const double given = wire.kind == WireKind::Earth ? 1.2 * 900 : 900;
    EXPECT_NEAR(a / given, 1, 0.02);
    const double lowest =
        0.5 * l - a * std::asinh(h / (2 * a * std::sinh(l / (2 * a))));
    for (const Point& p : wire.points) {
      const double along = (p - from).head<2>().norm();
      const double z =
          from.z() + a * (std::cosh((along - lowest) / a) - std::cosh(lowest / a));
      EXPECT_NEAR(p.z(), z, 0.002);
      // In the vertical plane through the attachments.
      const Point chord = to - from, off = p - from;
      EXPECT_NEAR((chord.x() * off.y() - chord.y() * off.x()) / l, 0, 1e-6);
    }
  }
  EXPECT_GE(whole, 7);
}

TEST(Corridor, WindSwingsWiresOutOfTheVertical)
{
  CorridorSettings s = smallScene(5);
  s.length = 600;
  s.density = 0.5;
  s.wind = 10;
  int whole = 0;
  for (const CorridorWire& wire : simulateCorridor(s).wires) {
    if (!wire.front_attached || !wire.back_attached)
      continue;
    ++whole;
    const Point from = wire.points.front(), chord = wire.points.back() - from;
    const double l = chord.head<2>().norm();
    const Point p = wire.points[wire.points.size() / 2], off = p - from;
    const double t = off.head<2>().dot(chord.head<2>()) / (l * l);
    const double aside = (chord.y() * off.x() - chord.x() * off.y()) / l;
    const double below = t * chord.z() - off.z();
    EXPECT_NEAR(std::atan2(aside, below) * 180 / M_PI, 10, 0.01);
  }
  EXPECT_GE(whole, 7);
}

TEST(Corridor, NeighboringSpansShareTheirAttachments)
{
  CorridorSettings s = smallScene(6);
  s.length = 700;
  s.density = 0.5;
  std::map<std::pair<int, int>, std::map<int, const CorridorWire*>> conductors;
  const CorridorScan scan = simulateCorridor(s);
  for (const CorridorWire& wire : scan.wires)
    conductors[{wire.line, wire.number}][wire.span] = &wire;
  int shared = 0;
  for (const auto& [key, spans] : conductors)
    for (const auto& [span, wire] : spans) {
      const auto next = spans.find(span + 1);
      if (next == spans.end())
        continue;
      ASSERT_TRUE(wire->back_attached && next->second->front_attached);
      EXPECT_LT((wire->points.back() - next->second->points.front()).norm(), 1e-9);
      ++shared;
    }
  EXPECT_GE(shared, 14);
}

TEST(Corridor, PointsOfWiresLieWithinBeamAndNoiseOfTheTruth)
{
  CorridorSettings s = smallScene(7);
  s.voltage = 380; // twin bundles
  s.earth_wires = 2;
  s.wind = 4;
  s.gaps = 0;
  const CorridorScan scan = simulateCorridor(s);
  CurveNetwork truth;
  for (const CorridorWire& wire : scan.wires) {
    Curve curve;
    curve.points = wire.points;
    truth.curves.push_back(curve);
  }
  const SegmentTree tree(truth);
  std::vector<double> points(scan.wires.size());
  const double reach = scan.beam_radius + 5 * s.range_noise + 4 * s.strip_error + 0.02;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    ASSERT_EQ(scan.classification[i] == 14, scan.wire[i] >= 0);
    if (scan.wire[i] < 0)
      continue;
    const auto w = static_cast<std::size_t>(scan.wire[i]);
    ASSERT_LT(w, scan.wires.size());
    ++points[w];
    EXPECT_LT(tree.nearestOn(w, scan.points[i]).squared_distance, reach * reach);
  }
  // Without gaps every wire is hit along its whole length by pulses of the covering
  // strip.
  const double most = s.density * 2 * (scan.beam_radius + 0.02);
  for (std::size_t w = 0; w < points.size(); ++w) {
    const double length = arcLength(scan.wires[w].points);
    if (length < 30)
      continue;
    EXPECT_GT(points[w] / length, 0.3 * most) << "wire " << w;
    EXPECT_LT(points[w] / length, 1.3 * most) << "wire " << w;
  }
}

TEST(Corridor, HoldsWhatItsSettingsRequest)
{
  CorridorSettings s = smallScene(8);
  s.outliers = 1e-3;
  const auto all = classCounts(simulateCorridor(s));
  for (const int c : {2, 3, 4, 5, 6, 7, 14, 15, 26})
    EXPECT_GT(all.count(c), 0U) << "class " << c;
  s.houses = s.cranes = s.fences = s.low_voltage = 0;
  s.trees = s.bushes = s.outliers = 0;
  const CorridorScan bare = simulateCorridor(s);
  for (const auto& [c, count] : classCounts(bare))
    EXPECT_TRUE(c == 2 || c == 14 || c == 15) << "class " << c << ": " << count;
  for (const CorridorWire& wire : bare.wires)
    EXPECT_NE(wire.kind, WireKind::LowVoltage);
}

TEST(Corridor, GapsTakeReturnsAway)
{
  CorridorSettings s = smallScene(9);
  s.gaps = 0;
  const double full = static_cast<double>(classCounts(simulateCorridor(s))[14]);
  s.gaps = 40; // 6.5 m on average: a quarter of the wires
  const double torn = static_cast<double>(classCounts(simulateCorridor(s))[14]);
  EXPECT_LT(torn, 0.88 * full);
  EXPECT_GT(torn, 0.6 * full);
}

TEST(Corridor, DensityAndAttributesAreThoseOfAScanner)
{
  for (const unsigned strips : {1U, 3U}) {
    CorridorSettings s = smallScene(10);
    s.strips = strips;
    const CorridorScan scan = simulateCorridor(s);
    double first = 0, several = 0;
    double last_time = 0;
    std::set<int> numbers;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      const int r = scan.return_number[i], n = scan.number_of_returns[i];
      ASSERT_TRUE(1 <= r && r <= n && n <= 5);
      first += r == 1 ? 1 : 0;
      several += n > 1 ? 1 : 0;
      ASSERT_GE(scan.gps_time[i], last_time);
      last_time = scan.gps_time[i];
      ASSERT_GT(scan.intensity[i], 0);
      ASSERT_LT(std::abs(scan.scan_angle[i]), 10);
      numbers.insert(scan.strip[i]);
    }
    EXPECT_NEAR(first / (s.length * s.width) / s.density, 1, 0.06);
    EXPECT_GT(several, 0.02 * first);
    EXPECT_EQ(numbers.size(), strips);
  }
}

TEST(Corridor, NothingIsSeenThroughRoofs)
{
  CorridorSettings s = smallScene(11);
  s.trees = s.bushes = s.fences = s.cranes = s.low_voltage = 0;
  s.houses = 8;
  s.outliers = 0;
  const CorridorScan scan = simulateCorridor(s);
  // Building points in all eight directions mean inside a house, farther in than a
  // slanting beam can see below the eaves. No ground return lies there.
  std::size_t inside = 0, covered = 0;
  Points roof;
  for (std::size_t i = 0; i < scan.points.size(); ++i)
    if (scan.classification[i] == 6)
      roof.push_back(scan.points[i]);
  ASSERT_GT(roof.size(), 300U);
  const auto surrounded = [&](const Point& center) {
    int sectors[8] = {};
    for (const Point& p : roof) {
      const Point d = p - center;
      if (d.head<2>().norm() < 1.5)
        ++sectors[static_cast<int>((std::atan2(d.y(), d.x()) + 3.1416) / 0.7854) % 8];
    }
    return std::all_of(sectors, sectors + 8, [](int n) { return n > 1; });
  };
  for (std::size_t i = 0; i < scan.points.size(); ++i)
    if (scan.classification[i] == 2)
      inside += surrounded(scan.points[i]) ? 1 : 0;
    else if (scan.classification[i] == 6)
      covered += surrounded(scan.points[i]) ? 1 : 0;
  EXPECT_GT(covered, 100U); // most roofs are wider than that
  EXPECT_EQ(inside, 0U);
}

TEST(Corridor, AnotherScanOfTheSameSceneLiesAtTheSamePlace)
{
  CorridorSettings s = smallScene(12);
  const CorridorScan one = simulateCorridor(s);
  s.density = 3;
  s.thin_ground = 4;
  s.strips = 2;
  const CorridorScan two = simulateCorridor(s);
  EXPECT_EQ(one.shift, two.shift);
  ASSERT_EQ(one.wires.size(), two.wires.size());
  for (std::size_t w = 0; w < one.wires.size(); ++w)
    EXPECT_EQ(one.wires[w].points, two.wires[w].points);
}

TEST(Corridor, ThinsTheGroundOnly)
{
  CorridorSettings s = smallScene(12);
  auto full = classCounts(simulateCorridor(s));
  s.thin_ground = 10;
  auto thin = classCounts(simulateCorridor(s));
  EXPECT_NEAR(static_cast<double>(thin[2]) / static_cast<double>(full[2]), 0.1, 0.01);
  EXPECT_NEAR(static_cast<double>(thin[6]) / static_cast<double>(full[6]), 1, 0.02);
  EXPECT_NEAR(static_cast<double>(thin[14]) / static_cast<double>(full[14]), 1, 0.1);
}

TEST(Corridor, RefusesSettingsOutOfRangeByName)
{
  const auto message = [](auto change) -> std::string {
    CorridorSettings s;
    change(s);
    try {
      simulateCorridor(s);
    }
    catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  using S = CorridorSettings;
  EXPECT_NE(message([](S& s) { s.length = -1; }).find("--length"), std::string::npos);
  EXPECT_NE(message([](S& s) { s.width = std::nan(""); }).find("--width"),
            std::string::npos);
  EXPECT_NE(message([](S& s) { s.density = 0; }).find("--density"), std::string::npos);
  EXPECT_NE(message([](S& s) { s.strips = 0; }).find("--strips"), std::string::npos);
  EXPECT_NE(message([](S& s) { s.low_voltage_wires = 0; }).find("--low-voltage-wires"),
            std::string::npos);
  EXPECT_NE(message([](S& s) { s.thin_ground = 0; }).find("--thin-ground"),
            std::string::npos);
}

TEST(Corridor, CanBeCanceled)
{
  class Impatient : public ProgressMonitor {
  public:
    bool
    canceled() const override
    {
      return true;
    }
  } monitor;
  EXPECT_THROW(simulateCorridor(smallScene(1), &monitor), Canceled);
}

} // namespace
