// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <linelet/fragments/ledger.h>
#include <linelet/fragments/plan.h>
#include <linelet/io/copc_ranges.h>
#include <linelet/io/point_file.h>
#include <linelet/io/usable_points.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC fragments {

/** \brief The points of one input in a fragment; they are contiguous. */
struct Section {
  std::size_t input = 0, first = 0, count = 0;
};

/** \brief The points of a fragment with its ghost zone, in the order of the inputs. */
struct Fragment {
  std::size_t number = 0;
  Points points;                     ///< relative to the plan's shift
  std::vector<std::uint8_t> classes; ///< of all points; 0 where they have none
  std::vector<std::uint8_t> returns; ///< of their pulses; 0 if unknown
  std::vector<std::uint32_t> places; ///< indices in their inputs
  std::vector<bool> core;            ///< whether the fragment owns them
  std::vector<Section> sections;     ///< by input

  /** \brief Number of points it owns. */
  std::size_t
  owned() const;
};

/** \brief Cuts inputs into pieces, from which fragments are assembled: each input is
 * read once, in blocks, and each usable point is written to every fragment whose box or
 * ghost zone contains it. COPC files are not cut: each fragment reads the nodes of the
 * octree that it touches. */
class Pieces {
public:
  /** \param[in] folder of the run
   * \param[in] options how to read, except for the shift, which is the plan's */
  Pieces(const Plan& plan,
         std::string folder,
         io::ReadOptions options,
         io::ClassFilter classes);

  /** \brief Cuts the inputs of fragment \a number that are not cut yet, one worker at a
   * time, and assembles it.
   * \throws io::FileError where an input cannot be read, or has points where its header
   * has none, or if another worker has finished the fragment; Canceled */
  Fragment
  load(std::size_t number, ProgressMonitor* monitor = nullptr) const;

  /** \brief Number of points that \ref load will find, or more if nodes of an octree
   * lie partly outside. Cuts inputs that are not cut yet. \throws as \ref load */
  std::uint64_t
  points(std::size_t number, ProgressMonitor* monitor = nullptr) const;

  /** \brief Removes the pieces of a fragment that is done. */
  void
  remove(std::size_t number) const;

private:
  using Ranges = std::optional<std::vector<io::PointRange>>;

  /** What a fragment takes from one input. */
  struct Share {
    std::size_t input;
    Ranges octree;
    std::uint64_t points; ///< of an octree: an upper bound
  };

  std::vector<Share>
  sharesOf(std::size_t number, ProgressMonitor* monitor) const;
  void
  cut(std::size_t input, ProgressMonitor* monitor) const;
  void
  refuseIfDone(std::size_t fragment) const;
  void
  cutOrTellWhyNot(std::size_t input, ProgressMonitor* monitor) const;
  std::uint64_t
  require(std::size_t input, std::size_t fragment, ProgressMonitor* monitor) const;
  Ranges
  octreeRanges(std::size_t input, std::size_t number) const;
  std::size_t
  appendOfOctree(std::size_t input,
                 const std::vector<io::PointRange>& ranges,
                 Fragment& fragment,
                 ProgressMonitor* monitor) const;
  void
  append(const Section& section, Fragment& fragment) const;
  std::string
  path(std::size_t fragment, std::size_t input) const;

  const Plan& plan_;
  double reach_; // of the plan, where computing it visits all inputs
  std::string folder_;
  io::ReadOptions options_;
  io::ClassFilter classes_;
  Ledger ledger_;
};

} // namespace fragments
} // namespace linelet
