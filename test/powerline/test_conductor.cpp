// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <fstream>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <linelet/io/file_error.h>
#include <linelet/powerline/strain_sections.h>

namespace {

using namespace linelet;
using namespace linelet::powerline;

constexpr double gravity = 9.80665;

double
levelSag(double tension, double load, double span)
{
  return tension / load * (std::cosh(load * span / (2 * tension)) - 1);
}

// A textbook exercise with its answer (Determination of the erection sag of an ACSR
// line, exercise 15.3 at bartleby.com/questions-and-answers, "Ans: 20.76 m; 541.9 kg"):
// span 300 m, 240 mm2, 20 mm, 1 kg/m, 8000 kg / 2, 9320 kg/mm2; -5 C with 1 cm of ice
// of 910 kg/m3 and 40 kg/m2 of wind, to 65 C in still air. The coefficient of expansion
// is used as printed, 18.44e-5, since the printed answer follows from it.
TEST(StateChange, AgreesWithATextbooksExercise)
{
  const Conductor conductor{"exercise", 240, 20, 1000, 9320 * gravity / 1000, 184.4};
  const double ice = M_PI * 0.01 * 0.03 * 910;
  const double worst = std::hypot(1 + ice, 40 * 0.04) * gravity;
  const double tension = tensionAfter(
      {{300, 0}}, {{300, 0}}, conductor, 4000 * gravity, worst, gravity, 70);
  EXPECT_NEAR(tension / gravity, 541.9, 5.4);
  EXPECT_NEAR(levelSag(tension, gravity, 300), 20.76, 0.21);
}

/** Ends of a cable of unstretched length \a length that starts with the forces H and V0
 * and stretches by Hooke's law: brute force, step by step (midpoint rule). */
struct Cable {
  double x = 0, z = 0;

  Cable(double h, double v0, double load, double stiffness, double length)
  {
    constexpr int steps = 4000;
    const double ds = length / steps;
    for (int k = 0; k < steps; ++k) {
      const double v = v0 + load * (k + 0.5) * ds, t = std::hypot(h, v);
      x += h / t * (1 + t / stiffness) * ds;
      z += v / t * (1 + t / stiffness) * ds;
    }
  }
};

double
bisect(double low, double high, const std::function<bool(double)>& is_above)
{
  for (int k = 0; k < 60; ++k)
    (is_above(0.5 * (low + high)) ? high : low) = 0.5 * (low + high);
  return 0.5 * (low + high);
}

/** Vertical force at the start for which the cable rises by \a rise. */
double
startForce(double h, double load, double stiffness, double length, double rise)
{
  return bisect(-load * length - h, h, [&](double v) {
    return Cable(h, v, load, stiffness, length).z > rise;
  });
}

TEST(StateChange, AgreesWithAnElasticCableSolvedByBruteForce)
{
  const Conductor drake = readConductor("Drake");
  const double stiffness = drake.modulus * 1e9 * drake.area * 1e-6;
  struct Case {
    double span, rise, tension;
    const char* state;
  };
  for (const Case& c : {Case{300, 0, 28000, "75C"},
                        Case{300, 40, 28000, "-20C"},
                        Case{120, -15, 15000, "100C"},
                        Case{600, 80, 30000, "0C,ice=20mm"},
                        Case{250, 0, 20000, "0C,ice=10mm,wind=400Pa"}}) {
    SCOPED_TRACE(c.state);
    const ConductorState state = parseState(c.state);
    const double load = loadOf(drake, {}).vertical;
    const ConductorLoad next = loadOf(drake, state);
    const double swing = std::atan2(next.horizontal, next.vertical);
    // In the tilted plane of the load (level spans only).
    const double warming = state.temperature - 15;
    const double after = tensionAfter({{c.span, c.rise}},
                                      {{c.span, c.rise / std::cos(swing)}},
                                      drake,
                                      c.tension,
                                      load,
                                      next.resultant(),
                                      warming);
    const auto reach = [&](double h, double w, double length) {
      return Cable(h, startForce(h, w, stiffness, length, c.rise), w, stiffness, length)
          .x;
    };
    const double length = bisect(c.span, 1.5 * c.span, [&](double l) {
      return reach(c.tension, load, l) > c.span;
    });
    // The weight belongs to the metal: warming lengthens it but makes it no heavier.
    const double grown = 1 + drake.expansion * 1e-6 * warming;
    const double truth = bisect(1000, 200000, [&](double h) {
      return reach(h, next.resultant() / grown, length * grown) > c.span;
    });
    EXPECT_NEAR(after, truth, 0.01 * truth);
  }
}

// The equation of the ruling span (CIGRE TB 324, 2007, 5.2), solved independently.
TEST(StateChange, OfLevelSpansIsThatOfTheRulingSpan)
{
  const Conductor hawk = readConductor("Hawk");
  const std::vector<SpanShape> spans = {{180, 0}, {260, 0}, {320, 0}, {210, 0}};
  const double ruling = rulingSpan(spans);
  EXPECT_NEAR(ruling,
              std::sqrt((std::pow(180., 3) + std::pow(260., 3) + std::pow(320., 3) +
                         std::pow(210., 3)) /
                        970),
              1e-9);
  const double w = loadOf(hawk, {}).vertical, stiffness = 77e9 * 281e-6;
  for (const double warming : {-35.0, 25.0, 60.0}) {
    const double h1 = 18000, k = std::pow(w * ruling, 2) * stiffness / 24;
    const double c = k / (h1 * h1) - h1 + stiffness * 18.9e-6 * warming;
    const double cubic =
        bisect(100, 100000, [&](double h) { return h * h * (h + c) > k; });
    EXPECT_NEAR(
        tensionAfter(spans, spans, hawk, h1, w, w, warming), cubic, 0.01 * cubic)
        << warming;
  }
}

TEST(StateChange, IsMonotonicAndNoneForNoChange)
{
  const Conductor drake = readConductor("Drake");
  const double w = loadOf(drake, {}).vertical;
  double last = 1e9;
  for (int t = -40; t <= 120; t += 10) {
    const double h = tensionAfter({{300, 10}}, {{300, 10}}, drake, 25000, w, w, t);
    EXPECT_LT(h, last);
    last = h;
    if (t == 0) {
      EXPECT_NEAR(h, 25000, 1e-6 * 25000);
    }
  }
  EXPECT_THROW(tensionAfter({{300, 0}}, {{300, 0}}, drake, 0, w, w, 0),
               std::invalid_argument);
  EXPECT_THROW(tensionAfter({}, {}, drake, 25000, w, w, 0), std::invalid_argument);
}

TEST(CatenaryBetween, MeetsBothEndsInASwungPlane)
{
  std::mt19937 random(20261122);
  std::uniform_real_distribution<double> one(-1, 1);
  for (int k = 0; k < 200; ++k) {
    const Point front(100 * one(random), 100 * one(random), 20 * one(random));
    const double direction = 3.14159 * one(random), length = 160 + 140 * one(random);
    const Point back = front + Point(length * std::sin(direction),
                                     length * std::cos(direction),
                                     0.2 * length * one(random));
    const double a = 800 + 600 * one(random), swing = k % 3 == 0 ? 0 : 50 * one(random);
    SCOPED_TRACE(testing::Message() << k << ": a " << a << ", swing " << swing);
    const Catenary curve = catenaryBetween(front, back, a, swing);
    EXPECT_LT((curve.at(curve.from) - front).norm(), 1e-8);
    EXPECT_LT((curve.at(curve.to) - back).norm(), 1e-8);
    EXPECT_EQ(curve.a, a);
  }
  // From south to north, right is east: there the ends are, relative to the vertex.
  const Catenary blown = catenaryBetween(Point(0, 0, 0), Point(0, 100, 0), 500, 30);
  EXPECT_LT(blown.at(0).x(), -0.5);
}

PowerLineNetwork
lineOf(const Points& attachments, const std::vector<double>& constants)
{
  PowerLineNetwork network;
  for (std::size_t k = 0; k + 1 < attachments.size(); ++k) {
    Wire wire;
    wire.id = static_cast<int>(k) + 1;
    wire.circuit = 1;
    wire.curve = catenaryBetween(attachments[k], attachments[k + 1], constants[k], 0);
    wire.front = attachments[k];
    wire.back = attachments[k + 1];
    wire.front_support = static_cast<int>(k) + 1;
    wire.back_support = static_cast<int>(k) + 2;
    wire.span_length = (wire.back - wire.front).head<2>().norm();
    wire.sag = levelSag(constants[k], 1, wire.span_length);
    wire.rms = 0.03;
    network.wires.push_back(wire);
  }
  return network;
}

TEST(MoveToState, NoChangeOfStateChangesNoCurve)
{
  const PowerLineNetwork network =
      lineOf({{0, 0, 30}, {250, 0, 35}, {520, 10, 31}}, {1000, 1010});
  StateSettings settings;
  settings.conductor = readConductor("Drake");
  settings.measured_temperature = 23;
  const StateOfWires same = moveToState(network, settings, parseState("23C"));
  ASSERT_EQ(same.wires.size(), 2U);
  EXPECT_EQ(same.sections.size(), 1U);
  for (std::size_t w = 0; w < 2; ++w)
    for (int k = 0; k <= 20; ++k) {
      const Catenary &a = network.wires[w].curve, &b = same.wires[w].curve;
      const double t = k / 20.0;
      EXPECT_LT(
          (a.at(a.from + t * (a.to - a.from)) - b.at(b.from + t * (b.to - b.from)))
              .norm(),
          1e-5);
    }
}

TEST(MoveToState, SectionsEndWhereConductorsAreDeadEnded)
{
  StateSettings settings;
  settings.conductor = readConductor("Drake");
  const ConductorState hot = parseState("80C");
  const auto sections = [&](const PowerLineNetwork& network) {
    return moveToState(network, settings, hot).sections.size();
  };
  const Points straight = {{0, 0, 30}, {250, 0, 30}, {500, 0, 30}, {750, 0, 30}};
  EXPECT_EQ(sections(lineOf(straight, {1000, 1005, 995})), 1U);
  // 40 % more tension is not scatter.
  EXPECT_EQ(sections(lineOf(straight, {1000, 1005, 1400})), 2U);
  const Points bent = {{0, 0, 30}, {250, 0, 30}, {450, 150, 30}, {650, 300, 30}};
  EXPECT_EQ(sections(lineOf(bent, {1000, 1000, 1000})), 2U);
  settings.dead_ends = {2, 3};
  EXPECT_EQ(sections(lineOf(straight, {1000, 1005, 995})), 3U);
  // A wire stored in the opposite direction still belongs to the same section.
  settings.dead_ends.clear();
  PowerLineNetwork turned = lineOf(straight, {1000, 1000, 1000});
  Wire& middle = turned.wires[1];
  std::swap(middle.front, middle.back);
  std::swap(middle.front_support, middle.back_support);
  middle.curve = catenaryBetween(middle.front, middle.back, 1000, 0);
  EXPECT_EQ(sections(turned), 1U);
  EXPECT_EQ(moveToState({}, settings, hot).sections.size(), 0U);
}

TEST(MoveToState, HeatLowersIceLowersWindSwings)
{
  const PowerLineNetwork network = lineOf({{0, 0, 30}, {0, 300, 30}}, {1200});
  StateSettings settings;
  settings.conductor = readConductor("240/40");
  const auto middle = [&](const char* state, double side) {
    const Catenary c =
        moveToState(network, settings, parseState(state), side).wires[0].curve;
    return c.at(0.5 * (c.from + c.to));
  };
  const double scanned = network.wires[0].curve.at(0).z();
  EXPECT_LT(middle("80C", 1).z(), scanned - 1);
  EXPECT_LT(middle("-5C,ice=20mm", 1).z(), scanned - 1);
  EXPECT_GT(middle("10C,wind=400Pa", 1).x(), 2); // to the right of north: east
  EXPECT_LT(middle("10C,wind=400Pa", -1).x(), -2);
  // Swung by the ratio of the loads.
  const ConductorLoad load = loadOf(settings.conductor, parseState("10C,wind=400Pa"));
  const Point blown = middle("10C,wind=400Pa", 1);
  EXPECT_NEAR(blown.x() / (30 - blown.z()), load.horizontal / load.vertical, 1e-6);
}

TEST(ConductorLoad, IsWeightIceAndWind)
{
  const Conductor conductor{"round", 300, 20, 1000, 70, 19};
  const ConductorLoad load = loadOf(conductor, parseState("0C,ice=10mm,wind=400Pa"));
  // A sleeve from 10 to 20 mm radius of 900 kg/m3; 400 Pa on 40 mm.
  const double sleeve = M_PI * (0.02 * 0.02 - 0.01 * 0.01) * 900;
  EXPECT_NEAR(load.vertical, (1 + sleeve) * gravity, 1e-9);
  EXPECT_NEAR(load.horizontal, 16, 1e-12);
}

TEST(ConductorState, IsReadOrRefusedWithASentence)
{
  const ConductorState state = parseState("-5.5C,wind=300Pa,ice=12mm");
  EXPECT_EQ(state.temperature, -5.5);
  EXPECT_EQ(state.ice, 12);
  EXPECT_EQ(state.wind, 300);
  for (const char* bad : {"",
                          "75",
                          "75F",
                          "ice=10mm",
                          "0C,ice=10",
                          "0C,ice=-1mm",
                          "nanC",
                          "0C,snow=3mm",
                          "5000C"})
    try {
      parseState(bad);
      ADD_FAILURE() << bad;
    }
    catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("75C"), std::string::npos);
    }
}

// A wrong digit in the table shows in the density of the metal and in how tightly the
// strands pack.
TEST(KnownConductors, WeighAsMuchAsAluminumAndSteel)
{
  for (const Conductor& c : knownConductors()) {
    EXPECT_GT(c.mass / c.area, 2.7) << c.name; // kg/km per mm2: g/cm3
    EXPECT_LT(c.mass / c.area, 3.6) << c.name;
    const double circle = M_PI / 4 * c.diameter * c.diameter;
    EXPECT_GT(c.area / circle, 0.70) << c.name;
    EXPECT_LT(c.area / circle, 0.80) << c.name;
    EXPECT_EQ(readConductor(c.name).area, c.area);
  }
}

TEST(ReadConductor, FromAFileOrWithAReason)
{
  const std::string path = testing::TempDir() + "linelet_conductor.txt";
  std::ofstream(path) << "# mine\narea 100\ndiameter 13 # mm\nmass 300\nmodulus "
                         "75\nexpansion 19\nname Own\n";
  const Conductor own = readConductor(path);
  EXPECT_EQ(own.name, "Own");
  EXPECT_EQ(own.modulus, 75);
  EXPECT_EQ(own.creep, 0);
  const auto complaint = [&](const std::string& text) {
    std::ofstream(path) << text;
    try {
      readConductor(path);
    }
    catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_NE(complaint("area 100\nwidth 3\n").find("line 2"), std::string::npos);
  EXPECT_NE(complaint("area many\n").find("area"), std::string::npos);
  EXPECT_NE(complaint("area 100\n").find("diameter"), std::string::npos);
  EXPECT_THROW(readConductor("Duck of nowhere"), io::FileError);
}

} // namespace
