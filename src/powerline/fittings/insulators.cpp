// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "powerline/fittings/insulators.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <linelet/tensor/eigen_analysis.h>
#include <linelet/tensor/neighborhood_tensor.h>

namespace linelet::powerline {

namespace {

constexpr std::size_t fewest_of_string = 5; // points of a string

int
supportOf(const WireEnd& end)
{
  return end.front ? end.wire->front_support : end.wire->back_support;
}

void
addTension(const SupportSite& site,
           const std::vector<SeenJumper>& jumpers,
           const FittingPriors& priors,
           std::vector<SeenString>& strings)
{
  std::vector<Indices> of(site.ends.size());
  for (Index i = 0; i < site.points.size(); ++i) {
    if (site.tube[i] < 0 || site.live[i] == 0)
      continue;
    const WireEnd& end = site.ends[static_cast<std::size_t>(site.tube[i])];
    if (end.clamped && site.along[i] <= end.clamp)
      of[static_cast<std::size_t>(site.tube[i])].push_back(i);
  }
  for (std::size_t e = 0; e < site.ends.size(); ++e) {
    const WireEnd& end = site.ends[e];
    if (of[e].size() < fewest_of_string ||
        end.clamp - end.earthed < priors.shortest_string)
      continue;
    SeenString seen;
    seen.string.kind = InsulatorString::Kind::Tension;
    seen.string.support = supportOf(end);
    seen.string.wire = end.wire->id;
    seen.end = static_cast<int>(e);
    seen.string.structure = end.at(end.earthed);
    seen.string.live = end.at(end.clamp);
    for (std::size_t j = 0; j < jumpers.size(); ++j)
      if (const Jumper& jumper = jumpers[j].jumper;
          jumper.from_wire == end.wire->id || jumper.to_wire == end.wire->id)
        seen.jumper = static_cast<int>(j);
    seen.points = std::move(of[e]);
    strings.push_back(std::move(seen));
  }
}

/** What a body of loose points touches. */
struct Touched {
  std::size_t end = 0;
  int jumper = -1;
  bool wire = false;
  bool earthed = false;
  Point live = Point::Zero(), structure = Point::Zero(); ///< nearest of each
};

class Hanging {
public:
  Hanging(const SupportSite& site,
          const std::vector<SeenJumper>& jumpers,
          const FittingPriors& priors)
      : site_(site), priors_(priors), jumper_(site.points.size(), -1)
  {
    for (std::size_t j = 0; j < jumpers.size(); ++j)
      for (const Index i : jumpers[j].points)
        jumper_[i] = static_cast<int>(j);
  }

  void
  add(std::vector<SeenString>& strings) const
  {
    const auto rests = [&](Index i) { return site_.isLoose(i) && jumper_[i] < 0; };
    for (Indices& body : bodiesOf(site_, priors_.link(), rests))
      if (SeenString seen; isString(body, seen)) {
        seen.points = std::move(body);
        strings.push_back(std::move(seen));
      }
  }

private:
  bool
  isString(const Indices& body, SeenString& seen) const
  {
    if (body.size() < fewest_of_string)
      return false;
    Points around;
    Point middle = Point::Zero();
    for (const Index i : body)
      middle += site_.points[i] / static_cast<double>(body.size());
    for (const Index i : body)
      around.push_back(site_.points[i] - middle);
    const EigenSystem axes =
        eigenAnalysis(neighborhoodTensor(around, Point::Zero(), 1, Kernel::Const));
    Point up = axes.major();
    if (up.z() < 0)
      up = -up;
    if (up.z() < priors_.level || std::sqrt(axes.values[1]) > priors_.half_width)
      return false;
    double low = 0, high = 0;
    for (const Point& p : around) {
      low = std::min(low, up.dot(p));
      high = std::max(high, up.dot(p));
    }
    const Touched touched = touchedBy(middle + low * up, middle + high * up);
    if (!touched.earthed || (!touched.wire && touched.jumper < 0))
      return false;
    InsulatorString& string = seen.string;
    string.live = touched.live;
    string.structure = touched.structure;
    const double length = (string.structure - string.live).norm();
    if (length < priors_.shortest_string || length > priors_.longest_string)
      return false;
    string.kind = touched.jumper >= 0 ? InsulatorString::Kind::Jumper
                                      : InsulatorString::Kind::Suspension;
    seen.jumper = touched.jumper;
    if (touched.jumper < 0) {
      const WireEnd& end = site_.ends[touched.end];
      string.wire = end.wire->id;
      seen.end = static_cast<int>(touched.end);
      string.support = supportOf(end);
    }
    return true;
  }

  // The structure above the upper end, wire or jumper below the lower one.
  Touched
  touchedBy(const Point& low, const Point& high) const
  {
    Touched touched;
    const double far = priors_.air_gap;
    double above = far * far, below = far * far;
    site_.grid->forEachWithin(high, far, [&](Index i, double squared) {
      if (site_.earthed[i] == 0 || squared > above)
        return;
      above = squared;
      touched.earthed = true;
    });
    site_.grid->forEachWithin(low, far, [&](Index i, double squared) {
      const bool wire = site_.tube[i] >= 0 && site_.live[i] != 0;
      if (squared > below || (!wire && jumper_[i] < 0) ||
          site_.points[i].z() > (low.z() + high.z()) / 2)
        return;
      below = squared;
      touched.jumper = jumper_[i];
      touched.wire = wire;
      if (wire)
        touched.end = static_cast<std::size_t>(site_.tube[i]);
    });

    touched.live = low;
    touched.structure = high;
    return touched;
  }

  const SupportSite& site_;
  const FittingPriors& priors_;
  std::vector<int> jumper_; ///< of every point, -1: none
};

} // namespace

std::vector<SeenString>
findInsulators(const SupportSite& site,
               const std::vector<SeenJumper>& jumpers,
               const FittingPriors& priors)
{
  std::vector<SeenString> strings;
  addTension(site, jumpers, priors, strings);
  Hanging(site, jumpers, priors).add(strings);
  for (SeenString& seen : strings) {
    seen.string.points = seen.points.size();
    seen.string.length = (seen.string.structure - seen.string.live).norm();
  }
  return strings;
}

} // namespace linelet::powerline
