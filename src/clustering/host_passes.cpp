// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "host_passes.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

#include "box_kernels.h"
#include "point_blocks.h"
#include "shared_bits.h"
#include "slot_runs.h"
#include "sum_points.h"
#include "support/huge_pages.h"
#include "support/parallel_failure.h"
#include "touched_cells.h"

namespace linelet::clustering {

namespace {

class HostPasses : public PointPasses {
public:
  HostPasses(const Points& points, std::vector<std::int32_t> field, int threads)
      : points_(points),
        field_(std::move(field)),
        threads_(threads),
        exact_(offsetBits(points.size()) <= exact_bits)
  {
  }

  void
  fill(CellDirectory& directory, const CellFrame& frame) override
  {
    const BlockLocator locator(directory, frame);
    if (!directory.markAll(points_.size())) {
      SharedBits bits(directory.marked.words.size());
      markCells(locator, bits, [](std::uint64_t key) {
        return key / CellDirectory::brick_cells;
      });
      bits.copyTo(directory.marked);
    }
    SharedBits bits(directory.marked.count * CellDirectory::brick_cells / 32);
    markCells(locator, bits, [&](std::uint64_t key) { return directory.bit(key); });
    bits.copyTo(directory.occupied);
  }

  void
  findHomes(CellDirectory& directory, const CellFrame& frame, double border) override
  {
    reserveHuge(assigned_, points_.size());
    assigned_.resize(points_.size());
    // Uninitialized: filling them on one thread would take as long as everything else.
    home_.reset(border > 0 ? new Index[points_.size()] : nullptr);
    face_.reset(border > 0 ? new std::uint8_t[points_.size()] : nullptr);
    runs_.clear();
    const BlockLocator locator(directory, frame, border, offsetBits(points_.size()));
    summed_ = false;
    if (TouchedCells::suit(directory.keys(), points_.size()))
      numberTouched(directory, locator, !frame.perspective);
    else {
      fill(directory, frame);
      lookUp(directory, locator);
    }
    slots_ = directory.slots();
  }

  void
  setOrigins(const std::vector<CellOrigin>& origins) override
  {
    origins_ = origins;
  }

  void
  setNeighbors(const Indices& neighbors) override
  {
    neighbors_ = neighbors;
  }

  std::vector<std::uint32_t>
  borderCounts() override
  {
    constexpr std::size_t row = faces * steps;
    std::vector<std::uint32_t> counts(slots_ * row);
    forOwned(home_.get(), [&](std::size_t i, Index home) {
      if (face_[i] != inside_cell)
        ++counts[home * row + face_[i]];
    });
    return counts;
  }

  const std::vector<CellSums>&
  sums() override
  {
    if (summed_)
      return sums_;
    sums_.assign(slots_, {});
    forOwned(assigned_.data(), [&](std::size_t i, Index slot) {
      addPoint<1>(points_[i], origins_[slot], sums_[slot]);
    });
    summed_ = true;
    return sums_;
  }

  std::vector<FieldSum>
  fieldSums() override
  {
    std::vector<FieldSum> sums(slots_);
    forOwned(assigned_.data(), [&](std::size_t i, Index slot) {
      if (field_[i] == no_value)
        return;
      ++sums[slot].count;
      sums[slot].sum += field_[i];
    });
    return sums;
  }

  void
  moveBySteps(const std::vector<std::uint8_t>& shifts) override
  {
    forMovable([&](std::size_t i, Index home, Index behind) {
      const std::uint32_t face = face_[i] / steps, step = face_[i] % steps;
      return step < shifts[home * faces + face] ? behind : home;
    });
  }

  void
  moveToPlanes(const std::vector<CellPlane>& planes) override
  {
    forMovable([&](std::size_t i, Index home, Index behind) {
      const Index here = assigned_[i], there = here == home ? behind : home;
      const double from_here = distance(planes[here], points_[i]);
      const double from_there = distance(planes[there], points_[i]);
      return from_there < from_here ? there : here;
    });
  }

  void
  moveByField(const std::vector<double>& means) override
  {
    forMovable([&](std::size_t i, Index home, Index behind) {
      const Index here = assigned_[i], there = here == home ? behind : home;
      const double value = field_[i];
      const bool better =
          field_[i] != no_value && value < means[here] && value > means[there];
      return better ? there : here;
    });
  }

  Indices
  assigned() override
  {
    return std::move(assigned_);
  }

private:
  /** \brief Calls work(begin, end, part) for as many parts of the points as there are
   * threads. */
  template <class Work>
  void
  forParts(const Work& work)
  {
    ParallelFailure failure;
    const auto parts = static_cast<std::size_t>(threads_);
#pragma omp parallel for num_threads(threads_) schedule(static, 1)
    for (int number = 0; number < threads_; ++number)
      failure.guard([&] {
        const auto part = static_cast<std::size_t>(number);
        work(points_.size() * part / parts, points_.size() * (part + 1) / parts, part);
      });
    failure.rethrow();
  }

  /** \brief Marks the numbers that \a number makes of the points' keys. */
  template <class Number>
  void
  markCells(const BlockLocator& locator, SharedBits& bits, const Number& number)
  {
    forParts([&](std::size_t begin, std::size_t end, std::size_t) {
      locator.forBlocks(points_, begin, end, [&](const PointBlock& block, std::size_t) {
        for (int run = 0; run < block.runs; ++run) {
          const double key = block.key[block.starts[run]];
          if (key != PointBlock::nowhere)
            bits.set(number(static_cast<std::uint64_t>(key)));
        }
      });
    });
  }

  /** \brief Whether every thread can have sums of its own for all cells. */
  bool
  sumsByThread() const
  {
    constexpr std::size_t few = 1U << 19;
    return slots_ * static_cast<std::size_t>(threads_) <=
           std::max(points_.size() / 4, few);
  }

  /** \brief Adds a run of points to the sums of their home, by offsets. */
  void
  addRun(const PointBlock& block, int first, int count, CellSums& sums) const
  {
    constexpr int few = 4; // that are faster added one by one
    if (count > few && exact_) {
      kernels_.add(block, first, count, sums);
      return;
    }
    CellSums sum;
    for (int i = first; i < first + count; ++i)
      addOffsets<1>(static_cast<std::int64_t>(block.offset[0][i]),
                    static_cast<std::int64_t>(block.offset[1][i]),
                    static_cast<std::int64_t>(block.offset[2][i]),
                    sum);
    sums += sum;
  }

  /** \brief Calls work(begin, end, sums) for parts of the points, with sums per thread
   * that are added up at the end. */
  template <class Work>
  void
  forPartsWithSums(const Work& work)
  {
    std::vector<std::vector<CellSums>> parts(static_cast<std::size_t>(threads_));
    forParts([&](std::size_t begin, std::size_t end, std::size_t part) {
      const std::size_t size = sumsByThread() ? slots_ : 0;
      reserveHuge(parts[part], size);
      parts[part].resize(size);
      work(begin, end, parts[part]);
    });
    if (!sumsByThread())
      return;
#pragma omp parallel for num_threads(threads_)
    for (std::ptrdiff_t k = 0; k < static_cast<std::ptrdiff_t>(slots_); ++k)
      for (const std::vector<CellSums>& sums : parts)
        sums_[static_cast<std::size_t>(k)] += sums[static_cast<std::size_t>(k)];
  }

  /** \brief Assigns to runs of points in one cell what slotOf(key, block, first of the
   * run, its length) returns. */
  template <class SlotOf>
  void
  assign(const BlockLocator& locator,
         std::size_t begin,
         std::size_t end,
         const SlotOf& slotOf)
  {
    Index slots[PointBlock::size + PointBlock::margin];
    locator.forBlocks(
        points_, begin, end, [&](const PointBlock& block, std::size_t start) {
          for (int run = 0; run < block.runs; ++run) {
            const int first = block.starts[run];
            const int last = run + 1 < block.runs ? block.starts[run + 1] : block.count;
            const double key = block.key[first];
            const Index slot =
                key != PointBlock::nowhere
                    ? slotOf(
                          static_cast<std::uint64_t>(key), block, first, last - first)
                    : CellDirectory::none;
            // Runs are short: what is written beyond one is overwritten by the next.
            for (int i = first; i < last; i += PointBlock::margin)
              std::fill_n(slots + i, PointBlock::margin, slot);
          }
          std::copy_n(slots, block.count, assigned_.data() + start);
          if (face_)
            std::copy_n(block.face, block.count, face_.get() + start);
        });
  }

  /** \brief Finds homes in one pass, as the cells are met, and fills the directory. */
  void
  numberTouched(CellDirectory& directory, const BlockLocator& locator, bool sum)
  {
    std::vector<std::vector<std::uint64_t>> keys(static_cast<std::size_t>(threads_));
    std::vector<std::vector<CellSums>> sums(keys.size());
    forParts([&](std::size_t begin, std::size_t end, std::size_t part) {
      TouchedCells cells(directory.keys(), end - begin);
      assign(locator,
             begin,
             end,
             [&](std::uint64_t key, const PointBlock& block, int first, int count) {
               const Index number = cells.number(key);
               if (sum)
                 addRun(block, first, count, cells.sums[number]);
               return number;
             });
      keys[part] = std::move(cells.keys);
      sums[part] = std::move(cells.sums);
    });
    directory.fillWith(keys);
    if (sum) {
      sums_ = {};
      reserveHuge(sums_, directory.slots());
      sums_.resize(directory.slots());
    }
    std::vector<Indices> slots(keys.size());
    for (std::size_t part = 0; part < keys.size(); ++part) {
      slots[part].reserve(keys[part].size());
      for (std::size_t k = 0; k < keys[part].size(); ++k) {
        const Index slot = directory.slot(keys[part][k]);
        slots[part].push_back(slot);
        if (sum)
          sums_[slot] += sums[part][k];
      }
    }
    summed_ = sum;
    forParts([&](std::size_t begin, std::size_t end, std::size_t part) {
      for (std::size_t i = begin; i < end; ++i)
        if (assigned_[i] != CellDirectory::none)
          assigned_[i] = slots[part][assigned_[i]];
      if (home_)
        std::copy(
            assigned_.data() + begin, assigned_.data() + end, home_.get() + begin);
    });
  }

  /** \brief Finds homes in a filled directory. */
  void
  lookUp(const CellDirectory& directory, const BlockLocator& locator)
  {
    forParts([&](std::size_t begin, std::size_t end, std::size_t) {
      assign(locator, begin, end, [&](std::uint64_t key, const PointBlock&, int, int) {
        return directory.slot(key);
      });
      if (home_)
        std::copy(
            assigned_.data() + begin, assigned_.data() + end, home_.get() + begin);
    });
  }

  /** \brief Calls work(point, slot) for all points with a slot; all points of a slot
   * are visited by one thread. */
  template <class Work>
  void
  forOwned(const Index* slots, const Work& work)
  {
    if (runs_.empty())
      runs_.share(assigned_, slots_, threads_);
    runs_.forPoints(slots, points_.size(), threads_, work);
  }

  /** \brief Reassigns the points near a border with a cell behind it. */
  template <class Work>
  void
  forMovable(const Work& work)
  {
    const bool by_thread = summed_ && sumsByThread();
    summed_ = by_thread;
    forPartsWithSums(
        [&](std::size_t begin, std::size_t end, std::vector<CellSums>& sums) {
          for (std::size_t i = begin; i < end; ++i) {
            if (face_[i] == inside_cell)
              continue;
            const Index behind = neighbors_[home_[i] * faces + face_[i] / steps];
            if (behind == CellDirectory::none)
              continue;
            const Index before = assigned_[i];
            assigned_[i] = work(i, home_[i], behind);
            if (!by_thread || assigned_[i] == before)
              continue;
            const Index now = assigned_[i];
            addPoint<-1>(points_[i], origins_[before], sums[before]);
            addPoint<1>(points_[i], origins_[now], sums[now]);
          }
        });
  }

  const Points& points_;
  std::vector<std::int32_t> field_;
  int threads_;
  std::size_t slots_ = 0;
  Indices neighbors_;
  std::vector<CellOrigin> origins_;
  std::vector<CellSums> sums_; // of what is assigned
  bool summed_ = false;        // whether they are
  Indices assigned_;
  std::unique_ptr<Index[]> home_; // these two where points may move
  std::unique_ptr<std::uint8_t[]> face_;
  SlotRuns runs_;
  BoxKernels kernels_ = boxKernels();
  bool exact_; // whether sums of a block in double are
};

} // namespace

std::unique_ptr<PointPasses>
hostPasses(const Points& points, std::vector<std::int32_t> field, int threads)
{
  return std::make_unique<HostPasses>(points, std::move(field), threads);
}

} // namespace linelet::clustering
