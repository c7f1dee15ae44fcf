// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "corridor_objects.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "corridor_members.h"

namespace linelet::bench::corridor {

namespace {

/** A house's own frame: u along the ridge, v across. */
struct Plot {
  Point center, u, v;

  Point
  at(double along, double across, double height) const
  {
    return center + along * u + across * v + height * Point::UnitZ();
  }
};

void
addQuad(Scene& scene, const Point& a, const Point& b, const Point& c, const Point& d)
{
  scene.panels.push_back({a, b, c, BuildingClass, 0.4F});
  scene.panels.push_back({a, c, d, BuildingClass, 0.4F});
}

void
addHouse(Scene& scene, const Plot& plot, Random& random)
{
  const double l = random.uniform(4.5, 8), w = random.uniform(3.5, 5.5);
  const double eaves = random.uniform(2.8, 6);
  const bool gabled = random.integer(0, 3) > 0;
  const double ridge = gabled ? eaves + w * random.uniform(0.5, 1) : eaves;
  const double over = 0.4; // overhang
  const double drop = gabled ? over * (ridge - eaves) / w : 0;
  for (const double s : {-1.0, 1.0}) {
    addQuad(scene,
            plot.at(-l, s * w, -1),
            plot.at(l, s * w, -1),
            plot.at(l, s * w, eaves),
            plot.at(-l, s * w, eaves));
    addQuad(scene,
            plot.at(s * l, -w, -1),
            plot.at(s * l, w, -1),
            plot.at(s * l, w, eaves),
            plot.at(s * l, -w, eaves));
    if (gabled)
      scene.panels.push_back({plot.at(s * l, -w, eaves),
                              plot.at(s * l, w, eaves),
                              plot.at(s * l, 0, ridge),
                              BuildingClass,
                              0.4F});
    addQuad(scene,
            plot.at(-l - over, s * (w + over), eaves - drop),
            plot.at(l + over, s * (w + over), eaves - drop),
            plot.at(l + over, 0, ridge),
            plot.at(-l - over, 0, ridge));
  }
  if (gabled) { // chimney
    const double at = random.uniform(-0.6, 0.6) * l;
    scene.beam(plot.at(at, 0.6, ridge - 1),
               plot.at(at, 0.6, ridge + 0.9),
               0.35,
               BuildingClass,
               0.4);
  }
  else // a parapet
    for (const double s : {-1.0, 1.0}) {
      scene.beam(plot.at(-l, s * w, eaves + 0.3),
                 plot.at(l, s * w, eaves + 0.3),
                 0.12,
                 BuildingClass,
                 0.5);
      scene.beam(plot.at(s * l, -w, eaves + 0.3),
                 plot.at(s * l, w, eaves + 0.3),
                 0.12,
                 BuildingClass,
                 0.5);
    }
  if (random.integer(0, 2) == 0) // aerial
    scene.beam(plot.at(0.3 * l, 0, ridge),
               plot.at(0.3 * l, 0, ridge + 2.5),
               0.03,
               OtherClass,
               0.5);
}

/** Square lattice boom of half width \a half from one end to the other. */
void
addBoom(Scene& scene, const Point& from, const Point& to, double half, double pitch)
{
  const Point along = (to - from).normalized();
  const Point side = std::abs(along.z()) > 0.9 ? Point(Point::UnitX())
                                               : Point(along.cross(Point::UnitZ()));
  const Point up = side.cross(along);
  Point bottom[4], top[4];
  const double sign[4][2] = {{1, 1}, {1, -1}, {-1, -1}, {-1, 1}};
  for (int i = 0; i < 4; ++i) {
    const Point off = half * (sign[i][0] * side + sign[i][1] * up);
    bottom[i] = from + off;
    top[i] = to + off;
  }
  const int bays = std::max(1, static_cast<int>((to - from).norm() / pitch));
  addLattice(scene, bottom, top, bays, 0.08, OtherClass);
}

void
addCrane(Scene& scene, const Point& base, double direction, Random& random)
{
  const double height = random.uniform(24, 40), jib = random.uniform(22, 38);
  const Point d(std::cos(direction), std::sin(direction), 0);
  const Point top = base + height * Point::UnitZ(), tip = top + jib * d;
  const Point head = top + 5 * Point::UnitZ(), back = top - 0.3 * jib * d;
  addBoom(scene, base, top, 0.8, 2);
  addBoom(scene, top, tip, 0.5, 2);
  addBoom(scene, top, back, 0.5, 2);
  scene.beam(top, head, 0.15, OtherClass, 0.5);
  scene.beam(head, top + 0.7 * jib * d, 0.03, OtherClass, 0.5);
  scene.beam(head, back, 0.03, OtherClass, 0.5);
  scene.beam(back, back - 2 * Point::UnitZ(), 0.9, OtherClass, 0.4); // counterweight
  const Point trolley = top + random.uniform(0.3, 0.9) * jib * d;
  scene.beam(trolley,
             trolley - random.uniform(5, height - 5) * Point::UnitZ(),
             0.02,
             OtherClass,
             0.5);
}

void
addFence(Scene& scene, const CorridorSettings& settings, Random& random)
{
  const double x = random.uniform(0, 0.6) * settings.length;
  const double y = random.uniform(-0.45, 0.45) * settings.width;
  const double direction = random.uniform(-0.5, 0.5);
  const double length = random.uniform(30, 90);
  const bool railing = random.integer(0, 1) == 0;
  const double height = railing ? 1.1 : random.uniform(1.2, 2);
  Point last[3];
  for (double s = 0; s <= length; s += 2.5) {
    Point p(x + s * std::cos(direction), y + s * std::sin(direction), 0);
    p.z() = scene.terrain.height(p.x(), p.y());
    const Point top = p + height * Point::UnitZ();
    scene.beam(p, top, 0.05, OtherClass, 0.4);
    for (int rail = 0; rail < 3; ++rail) {
      const Point at = p + (1 - 0.35 * rail) * height * Point::UnitZ();
      if (s > 0)
        scene.beam(last[rail], at, railing ? 0.025 : 0.004, OtherClass, 0.5);
      last[rail] = at;
    }
  }
}

void
addTree(Scene& scene, const Point& base, double height, Random& random)
{
  const bool conifer = random.integer(0, 2) == 0;
  const double wide = height * random.uniform(0.16, 0.26) * (conifer ? 0.7 : 1);
  const double leafless = height * random.uniform(0.15, 0.3);
  scene.beam(base,
             base + 0.8 * height * Point::UnitZ(),
             0.012 * height + 0.03,
             VegetationClass,
             0.4);
  // A conifer is a stack that narrows upward; a broad-leaved crown is a few round
  // masses.
  const int parts = conifer ? 4 : 3;
  for (int i = 0; i < parts; ++i) {
    const double t = (i + 0.5) / parts, tall = (height - leafless) / parts;
    const double r = conifer ? wide * (1.15 - t) : wide * random.uniform(0.7, 1);
    const double aside = conifer ? 0 : 0.45 * wide;
    const double dx = random.uniform(-aside, aside), dy = random.uniform(-aside, aside);
    scene.crowns.push_back({base + Point(dx, dy, leafless + t * (height - leafless)),
                            Point(r, r, conifer ? 0.7 * tall : 0.5 * tall + 0.2 * r),
                            random.uniform(0.7, 1.6)});
  }
}

/** Places for objects on the ground of a corridor. */
class Ground {
public:
  Ground(Scene& scene, const CorridorSettings& settings, Random& random)
      : scene_(scene),
        length_(settings.length),
        half_(0.5 * settings.width),
        random_(random)
  {
  }

  Point
  anywhere()
  {
    const double x = random_.uniform(0, length_);
    return at(x, random_.uniform(-half_, half_));
  }

  /** A place about 5 m from \a other. */
  Point
  near(const Point& other)
  {
    const double dx = random_.normal(5), dy = random_.normal(5);
    return at(std::clamp(other.x() + dx, 0.0, length_),
              std::clamp(other.y() + dy, -half_, half_));
  }

  /** Calls \a put for each of \a count objects, at one place after another until it
   * finds room. */
  template <class Put>
  void
  scatter(unsigned count, Put&& put)
  {
    constexpr int attempts = 40;
    for (unsigned i = 0; i < count; ++i)
      for (int attempt = 0; attempt < attempts; ++attempt)
        if (put(anywhere()))
          break;
  }

private:
  Point
  at(double x, double y) const
  {
    return {x, y, scene_.terrain.height(x, y)};
  }

  Scene& scene_;
  double length_, half_; // of the corridor; half its width
  Random& random_;
};

bool
putHouse(Scene& scene, const Point& p, Random& random)
{
  if (scene.lowestWire(p.x(), p.y(), 11) < p.z() + 14 || !scene.take(p.x(), p.y(), 10))
    return false;
  const double turn = random.uniform(0, pi);
  const Point u(std::cos(turn), std::sin(turn), 0),
      v(-std::sin(turn), std::cos(turn), 0);
  addHouse(scene, {p, u, v}, random);
  return true;
}

bool
putCrane(Scene& scene, const Point& p, Random& random)
{
  // The jib runs along the line: across, it would be in the wires.
  const double sense = random.integer(0, 1) * pi;
  const double turn = sense + random.uniform(-0.15, 0.15);
  bool clear = true;
  for (double s = -12; s <= 40; s += 4)
    clear = clear && scene.lowestWire(p.x() + s * std::cos(turn),
                                      p.y() + s * std::sin(turn),
                                      9) > 1e6;
  if (!clear || !scene.take(p.x(), p.y(), 4))
    return false;
  addCrane(scene, p, turn, random);
  return true;
}

void
addTrees(Scene& scene, int count, Ground& ground, Random& random)
{
  Point last = ground.anywhere();
  for (int i = 0; i < count; ++i) {
    // Every other tree is close to the previous one: groves, rows and lone trees.
    Point p = ground.anywhere();
    if (random.integer(0, 1) == 0)
      p = ground.near(last);
    last = p;
    double height = random.uniform(5, 22);
    // Below and beside wires they are trimmed now and then, not always in time.
    const double room = scene.lowestWire(p.x(), p.y(), 0.25 * height + 3) - p.z() -
                        random.uniform(2, 9);
    height = std::min(height, room);
    if (height >= 3 && scene.take(p.x(), p.y(), 0.08 * height))
      addTree(scene, p, height, random);
  }
}

void
addBushes(Scene& scene, int count, Ground& ground, Random& random)
{
  for (int i = 0; i < count; ++i) {
    const Point p = ground.anywhere();
    const double r = random.uniform(0.5, 1.8), tall = random.uniform(0.4, 1.2);
    if (scene.take(p.x(), p.y(), 0.5 * r))
      scene.crowns.push_back({p + 0.6 * tall * Point::UnitZ(),
                              Point(r, r, tall),
                              random.uniform(0.3, 0.8)});
  }
}

} // namespace

void
addObjects(Scene& scene, const CorridorSettings& settings, Random& random)
{
  Ground ground(scene, settings, random);
  ground.scatter(settings.houses,
                 [&](const Point& p) { return putHouse(scene, p, random); });
  ground.scatter(settings.cranes,
                 [&](const Point& p) { return putCrane(scene, p, random); });
  for (unsigned i = 0; i < settings.fences; ++i)
    addFence(scene, settings, random);
  const double hectares = settings.length * settings.width / 1e4;
  addTrees(scene, static_cast<int>(settings.trees * hectares), ground, random);
  addBushes(scene, static_cast<int>(settings.bushes * hectares), ground, random);
}

} // namespace linelet::bench::corridor
