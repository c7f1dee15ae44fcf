// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "curve_track.h"

#include <algorithm>
#include <cmath>

namespace linelet {

namespace {

constexpr double gate_width = 3;  // standard deviations
constexpr double ring_width = 3;  // gates
constexpr double stretch = 4;     // points expected on the stretch looked at
constexpr double memory = 40;     // points over which density and noise are averaged
constexpr double first_trust = 6; // points that the seed's values count as
// Mean number of points over which a curve is visible, and then hidden.
constexpr double visible_points = 60, hidden_points = 12;
// Share of its points that are seen where it is hidden: crowns let some pulses through.
// Chosen on simulated forests, not estimated; with 0, more wires are lost in crowns.
constexpr double seen_through = 0.3;
// Shares of the bending with which a promising curve is followed again: a stiff one is
// found again behind a crown in which a freer one has lost its way.
constexpr double stiffer[] = {0.1, 0.01};
constexpr double widest_gate = 2; // of the spacing of the points, times the stretch
constexpr std::size_t loop_points = 12;

/** \brief One pass along a curve in one direction. */
class Pass {
public:
  Pass(const TrackedScene& scene,
       const TrackBending& bending,
       double patience,
       unsigned most_points)
      : scene_(scene), bending_(bending), patience_(patience), most_points_(most_points)
  {
  }

  TrackState state;
  double density = 0, noise = 0;
  std::vector<Track::Member> members;
  Points path;
  double evidence = 0;
  double dispersion = 1;
  TrackState last; ///< where the evidence was greatest

  void
  run()
  {
    last = state;
    double best_density = density, best_noise = noise;
    std::size_t kept = 0;
    double score = 0;
    double count = first_trust, length = first_trust / density;
    double squares = first_trust * noise * noise, weights = first_trust;
    double visible = 1;
    double chi_square = 0, freedom = 0;
    Surroundings around;
    const auto pass = [&](double h) {
      if (!(h > 0))
        return;
      state.advance(h, walk());
      const double hide = density / visible_points, show = density / hidden_points;
      const double unseen = std::exp(-seen_through * density * h); // where hidden
      const double still = std::exp(-show * h);                    // hidden
      const double shown = visible * std::exp(-(density + hide) * h) +
                           (1 - visible) * (1 - still) * unseen;
      const double hidden =
          (1 - visible) * still * unseen + visible * (1 - std::exp(-hide * h));
      score += std::log(shown + hidden);
      length += visible * h;
      visible = shown / (shown + hidden);
    };
    while (score > evidence - patience_) {
      const double h = stretch / density;
      TrackState end = state;
      end.advance(h, walk());
      const double gate = gate_width * std::sqrt(end.covariance(0, 0) + noise * noise);
      if (gate > widest_gate * h)
        break;
      lookAhead(scene_, state, h, gate, ring_width * gate, around);
      chi_square += around.chi_square;
      freedom += around.freedom;
      double place = 0;
      bool looped = false;
      for (const auto& near : around.near) {
        pass(near.place - place);
        place = near.place;
        const Point offset = state.across(scene_.points()[near.index] - state.at);
        const double variance = state.covariance(0, 0) + noise * noise;
        const double squared = offset.squaredNorm();
        const double ratio = density * std::exp(-0.5 * squared / variance) /
                             (2 * M_PI * variance * around.background);
        const double gain = (visible + (1 - visible) * seen_through) * ratio;
        const double weight = gain / (gain + 1);
        score += std::log1p(gain);
        visible *= (1 + ratio) / (1 + gain);
        if (weight < 0.05)
          continue;
        squares += weight * std::max(0.0, 0.5 * squared - state.covariance(0, 0));
        weights += weight;
        count += weight * visible; // as is the length
        state.observe(offset, noise * noise, weight);
        if (count > memory) {
          length *= memory / count;
          count = memory;
        }
        if (weights > memory) {
          squares *= memory / weights;
          weights = memory;
        }
        members.push_back({near.index, weight});
        path.push_back(state.at);
        if (score > evidence) {
          evidence = score;
          kept = members.size();
          last = state;
          best_density = density;
          best_noise = noise;
          dispersion = std::max(1.0, (chi_square + 24) / (freedom + 24));
        }
        if (members.size() > loop_points && !first_.empty() &&
            std::find(first_.begin(), first_.end(), near.index) != first_.end())
          looped = true;
        if (members.size() <= loop_points / 2)
          first_.push_back(near.index);
      }
      density = count / length;
      noise = std::max(std::sqrt(squares / weights), least_track_noise * scene_.unit);
      pass(h - place);
      // A track that enters a loop after its first points never comes back to them.
      const bool looping = looped || members.size() > scene_.points().size();
      if (looping || (most_points_ > 0 && members.size() >= most_points_))
        break;
    }
    members.resize(kept);
    path.resize(kept);
    density = best_density;
    noise = best_noise;
  }

private:
  double
  walk() const
  {
    const double reach = bending_.points / density;
    return 3 * bending_.turn * bending_.turn / (reach * reach * reach);
  }

  const TrackedScene& scene_;
  TrackBending bending_;
  double patience_;
  unsigned most_points_;
  Indices first_;
};

Track
trackOf(Pass&& pass)
{
  Track track;
  track.members = std::move(pass.members);
  track.path = std::move(pass.path);
  track.evidence = pass.evidence / pass.dispersion; // quasi-likelihood
  track.density = pass.density;
  track.noise = pass.noise;
  return track;
}

/** \brief \a state reversed, and less certain: the points it knows will be seen again.
 */
TrackState
turned(TrackState state)
{
  state.reverse();
  state.covariance *= 4;
  return state;
}

} // namespace

double
Track::weight() const
{
  double sum = 0;
  for (const Member& m : members)
    sum += m.weight;
  return sum;
}

Track
followCurve(const TrackedScene& scene,
            const TrackSeed& seed,
            const TrackBending& bending,
            double patience,
            unsigned most_points,
            double promising)
{
  Pass first(scene, bending, patience, most_points);
  first.density = seed.density;
  first.noise = std::max(seed.noise, least_track_noise * scene.unit);
  first.state.at = seed.at;
  first.state.direction = seed.direction;
  const double turn = std::max(0.02, 2 * first.noise / seed.radius);
  first.state.covariance =
      Point(first.noise * first.noise, turn * turn, std::pow(0.1 / seed.radius, 2))
          .asDiagonal();
  first.run();
  if (first.members.size() < 3)
    return {};
  const auto back = [&](const Pass& before, const TrackBending& how) {
    Pass pass(scene, how, patience, most_points);
    pass.density = before.density;
    pass.noise = before.noise;
    pass.state = turned(before.last);
    pass.state.at -= 1e-3 * scene.unit * pass.state.direction;
    pass.run();
    return pass;
  };
  Pass second = back(first, bending);
  if (second.members.size() < 4)
    return {};
  if (second.evidence < promising * second.dispersion)
    return trackOf(std::move(second));
  Track best = trackOf(back(second, bending));
  for (const double share : stiffer) {
    const TrackBending stiff = {share * bending.turn, bending.points};
    Track track = trackOf(back(back(second, stiff), stiff));
    if (track.evidence <= best.evidence)
      break;
    best = std::move(track);
  }
  return best;
}

} // namespace linelet
