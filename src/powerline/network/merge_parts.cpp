// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/powerline/network_part.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "powerline/fittings/join_fittings.h"
#include "powerline/network/describe_wires.h"
#include "powerline/network/join_lines.h"
#include "powerline/network/loose_wires.h"
#include "powerline/network/number_wires.h"
#include "powerline/network/wire_index.h"
#include "powerline/spans/wire_with_ends.h"
#include "powerline/supports/place_order.h"

namespace linelet::powerline {

namespace {

constexpr double axes_apart = 3;    // meters between axes of one support in two parts
constexpr double border_part = .02; // of a wire, between its middles in two parts
constexpr double length_apart = 2;  // meters, for a wire that both see completely

/** A wire that was taken, in terms of the whole. */
struct Taken {
  std::size_t part = 0, place = 0;   ///< where from
  WireWithEnds hung;                 ///< its ends know wires and supports of the whole
  std::array<std::size_t, 2> told{}; ///< the parts that the ends are from
  Wire wire;
};

class Merging {
public:
  explicit Merging(const std::vector<NetworkPart>& parts)
      : parts_(parts), seen_(parts.size()), same_(parts.size()), support_(parts.size())
  {
  }

  PowerLineNetwork
  run(std::vector<PartIds>& ids)
  {
    takeWires();
    takeSupports();
    for (Taken& taken : taken_)
      hang(taken);
    settleEnds();
    matchPartners();
    for (Taken& taken : taken_)
      fitAgain(taken);
    const std::vector<int> numbers = number();
    tell(numbers, ids);
    joinFittings(parts_, ids, network_);
    for (const NetworkPart& part : parts_)
      for (const UnexplainedLine& line : part.unexplained)
        for (UnexplainedLine& stretch : clipLine(line, part.owns))
          network_.unexplained.push_back(std::move(stretch));
    joinLines(network_.unexplained);
    return std::move(network_);
  }

private:
  /** The taken wire that is the same as \a wire, or -1. If its part has both, like
   * conductors of a bundle, they are different. */
  int
  takenAs(const Wire& wire) const
  {
    const int known = index_.find(wire);
    if (known == WireIndex::none)
      return -1;
    const Taken& taken = taken_[static_cast<std::size_t>(known)];
    const int there = seen_[taken.part].find(wire);
    return there == static_cast<int>(taken.place) ? known : -1;
  }

  const LooseWire&
  loose(const Taken& taken) const
  {
    return parts_[taken.part].wires[taken.place];
  }

  /** Takes the wires with an owner, then those whose middle lies between two. */
  void
  takeWires()
  {
    struct Offer {
      std::size_t part, place;
      bool owned;
      double length;
    };
    for (std::size_t p = 0; p < parts_.size(); ++p)
      for (const LooseWire& one : parts_[p].wires)
        seen_[p].add(one.wire);
    std::vector<Offer> offers;
    for (std::size_t p = 0; p < parts_.size(); ++p)
      for (std::size_t w = 0; w < parts_[p].wires.size(); ++w) {
        const Wire& wire = parts_[p].wires[w].wire;
        const Point middle = middleOf(wire);
        const bool owned = parts_[p].owns(middle.x(), middle.y());
        if (owned || isBeside(parts_[p], middle, border_part * wire.length))
          offers.push_back({p, w, owned, wire.length});
      }
    // A truncated piece lies on one that is not.
    std::stable_sort(offers.begin(), offers.end(), [](const Offer& a, const Offer& b) {
      return std::tuple(!a.owned, -a.length) < std::tuple(!b.owned, -b.length);
    });
    for (const Offer& offer : offers) {
      const Wire& wire = parts_[offer.part].wires[offer.place].wire;
      if (takenAs(wire) >= 0)
        continue;
      index_.add(wire);
      taken_.emplace_back();
      taken_.back().part = offer.part;
      taken_.back().place = offer.place;
      taken_.back().wire = wire;
    }
    for (std::size_t p = 0; p < parts_.size(); ++p)
      for (const LooseWire& one : parts_[p].wires)
        same_[p].push_back(takenAs(one.wire));
    for (std::size_t k = 0; k < taken_.size(); ++k)
      same_[taken_[k].part][taken_[k].place] = static_cast<int>(k);
  }

  static bool
  isBeside(const NetworkPart& part, const Point& p, double step)
  {
    for (const double x : {-step, step})
      for (const double y : {-step, step})
        if (part.owns(p.x() + x, p.y() + y))
          return true;
    return false;
  }

  int
  supportAt(const Support& support) const
  {
    int best = -1;
    double least = axes_apart;
    for (std::size_t k = 0; k < network_.supports.size(); ++k) {
      const double far = (network_.supports[k].base - support.base).head<2>().norm();
      if (far < least) {
        least = far;
        best = static_cast<int>(k);
      }
    }
    return best;
  }

  /** Takes the supports with an owner, and those of wires that were taken. */
  void
  takeSupports()
  {
    struct Offer {
      std::size_t part, place;
      bool owned;
    };
    std::vector<std::vector<bool>> needed;
    for (const NetworkPart& part : parts_)
      needed.emplace_back(part.supports.size(), false);
    for (const Taken& taken : taken_)
      for (const LooseWire::End& end : loose(taken).ends)
        if (end.support >= 0)
          needed[taken.part][static_cast<std::size_t>(end.support)] = true;
    std::vector<Offer> offers;
    for (std::size_t p = 0; p < parts_.size(); ++p)
      for (std::size_t s = 0; s < needed[p].size(); ++s) {
        const Point& base = parts_[p].supports[s].base;
        const bool owned = parts_[p].owns(base.x(), base.y());
        if (owned || needed[p][s])
          offers.push_back({p, s, owned});
      }
    std::stable_sort(offers.begin(), offers.end(), [](const Offer& a, const Offer& b) {
      return a.owned && !b.owned;
    });
    std::vector<std::size_t> of_part;
    for (const Offer& offer : offers) {
      const Support& support = parts_[offer.part].supports[offer.place];
      const int known = supportAt(support);
      if (known >= 0 && of_part[static_cast<std::size_t>(known)] != offer.part)
        continue;
      network_.supports.push_back(support);
      of_part.push_back(offer.part);
    }
    std::sort(network_.supports.begin(),
              network_.supports.end(),
              [](const Support& a, const Support& b) {
                return std::tuple(a.base.x(), a.base.y()) <
                       std::tuple(b.base.x(), b.base.y());
              });
    for (std::size_t k = 0; k < network_.supports.size(); ++k)
      network_.supports[k].id = static_cast<int>(k) + 1;
    for (std::size_t p = 0; p < parts_.size(); ++p)
      for (const Support& support : parts_[p].supports)
        support_[p].push_back(supportAt(support));
  }

  int
  sameWire(std::size_t part, int place) const
  {
    return place < 0 ? -1 : same_[part][static_cast<std::size_t>(place)];
  }

  /** Which end of \a taken corresponds to the end \a end of \a other, the same wire. */
  static std::size_t
  endAt(const Taken& taken, const LooseWire& other, int end)
  {
    const WireWithEnds seen = hungAgain(other);
    const bool same = taken.hung.model().direction.dot(seen.model().direction) > 0;
    return static_cast<std::size_t>(same ? end : 1 - end);
  }

  /** The end \a end of a wire of \a part, in terms of the whole; the partner's end is
   * known once all wires are taken. */
  End
  endOf(std::size_t part, const LooseWire::End& end) const
  {
    End result;
    result.place = end.place;
    result.fixed = end.fixed;
    result.support =
        end.support < 0 ? -1 : support_[part][static_cast<std::size_t>(end.support)];
    result.partner = sameWire(part, end.partner);
    return result;
  }

  void
  hang(Taken& taken) const
  {
    taken.hung = hungAgain(loose(taken));
    for (std::size_t e = 0; e < 2; ++e)
      taken.hung.ends[e] = endOf(taken.part, loose(taken).ends[e]);
    taken.told = {taken.part, taken.part};
  }

  /** The owner of a support has seen all of its wires. */
  void
  settleEnds()
  {
    for (std::size_t p = 0; p < parts_.size(); ++p)
      for (std::size_t w = 0; w < parts_[p].wires.size(); ++w) {
        const LooseWire& seen = parts_[p].wires[w];
        if (same_[p][w] < 0)
          continue;
        Taken& taken = taken_[static_cast<std::size_t>(same_[p][w])];
        if (taken.part == p ||
            std::abs(seen.wire.length - taken.wire.length) > length_apart)
          continue;
        for (int e = 0; e < 2; ++e) {
          const LooseWire::End& end = seen.ends[static_cast<std::size_t>(e)];
          if (end.support < 0)
            continue;
          const Point& base =
              parts_[p].supports[static_cast<std::size_t>(end.support)].base;
          if (!parts_[p].owns(base.x(), base.y()))
            continue;
          const std::size_t at = endAt(taken, seen, e);
          taken.hung.ends[at] = endOf(p, end);
          taken.told[at] = p;
        }
      }
  }

  /** Partners come in pairs, and end at the same point unless a part that saw both
   * knows better. */
  void
  matchPartners()
  {
    const auto nearestEnd = [](const Taken& taken, const Point& place) {
      return (taken.hung.ends[0].place - place).norm() <=
                     (taken.hung.ends[1].place - place).norm()
                 ? 0
                 : 1;
    };
    for (std::size_t k = 0; k < taken_.size(); ++k)
      for (End& end : taken_[k].hung.ends) {
        if (end.partner == static_cast<int>(k))
          end.partner = -1;
        if (end.partner >= 0)
          end.partner_side =
              nearestEnd(taken_[static_cast<std::size_t>(end.partner)], end.place);
      }
    for (std::size_t k = 0; k < taken_.size(); ++k)
      for (std::size_t e = 0; e < 2; ++e) {
        End& end = taken_[k].hung.ends[e];
        if (end.partner < 0)
          continue;
        Taken& partner = taken_[static_cast<std::size_t>(end.partner)];
        const auto side = static_cast<std::size_t>(end.partner_side);
        End& other = partner.hung.ends[side];
        if (other.partner < 0) {
          other.partner = static_cast<int>(k);
          other.partner_side = static_cast<int>(e);
        }
        if (other.partner != static_cast<int>(k) ||
            other.partner_side != static_cast<int>(e)) {
          end.partner = -1;
          continue;
        }
        if (partner.told[side] == taken_[k].told[e])
          continue;
        other.place = end.place;
        other.fixed = end.fixed;
      }
  }

  /** Fits a wire again whose attachment points others knew better. */
  void
  fitAgain(Taken& taken) const
  {
    const LooseWire& before = loose(taken);
    bool changed = false;
    for (std::size_t e = 0; e < 2; ++e)
      changed = changed || before.ends[e].fixed != taken.hung.ends[e].fixed ||
                before.ends[e].place != taken.hung.ends[e].place;
    if (changed && !before.points.empty())
      fitWire(taken.wire, taken.hung, before.points);
    taken.wire.front_support = taken.hung.ends[0].support + 1;
    taken.wire.back_support = taken.hung.ends[1].support + 1;
  }

  /** \return the id of each of \ref taken_ */
  std::vector<int>
  number()
  {
    std::vector<WireWithEnds> hung;
    for (Taken& taken : taken_)
      hung.push_back(std::move(taken.hung));
    const std::vector<std::size_t> order = orderByPlace(hung);
    std::vector<int> now(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
      now[order[k]] = static_cast<int>(k);
    std::vector<WireWithEnds> sorted;
    for (const std::size_t k : order) {
      sorted.push_back(std::move(hung[k]));
      for (End& end : sorted.back().ends)
        if (end.partner >= 0)
          end.partner = now[static_cast<std::size_t>(end.partner)];
      network_.wires.push_back(taken_[k].wire);
    }
    const std::vector<int> ids = numberWires(network_, sorted);
    std::vector<int> numbers(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
      numbers[order[k]] = ids[k];
    return numbers;
  }

  void
  tell(const std::vector<int>& numbers, std::vector<PartIds>& ids) const
  {
    ids.assign(parts_.size(), {});
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      ids[p].wires.assign(parts_[p].wires.size() + 1, 0);
      for (std::size_t w = 0; w < parts_[p].wires.size(); ++w)
        if (const int k = same_[p][w]; k >= 0)
          ids[p].wires.at(static_cast<std::size_t>(parts_[p].wires[w].wire.id)) =
              numbers[static_cast<std::size_t>(k)];
      ids[p].supports.assign(parts_[p].supports.size() + 1, 0);
      for (std::size_t s = 0; s < parts_[p].supports.size(); ++s)
        ids[p].supports.at(static_cast<std::size_t>(parts_[p].supports[s].id)) =
            support_[p][s] + 1;
    }
  }

  const std::vector<NetworkPart>& parts_;
  std::vector<Taken> taken_;
  WireIndex index_;                       ///< of the taken, in their order
  std::vector<WireIndex> seen_;           ///< the wires of each part
  std::vector<std::vector<int>> same_;    ///< of each part: its wires among the taken
  std::vector<std::vector<int>> support_; ///< likewise its supports in the network
  PowerLineNetwork network_;
};

} // namespace

PowerLineNetwork
mergeParts(const std::vector<NetworkPart>& parts, std::vector<PartIds>& ids)
{
  return Merging(parts).run(ids);
}

} // namespace linelet::powerline
