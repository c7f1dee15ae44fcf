// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <linelet/curves/curve_network.h>
#include <linelet/features/multi_scale.h>
#include <linelet/features/point_types.h>
#include <linelet/powerline/power_line_network.h>
#include <linelet/powerline/review.h>

#include "analysis_settings.h"
#include "coloring.h"
#include "neighborhood.h"
#include "scene.h"
#include "worker.h"

namespace linelet::view {

/** \brief What was computed, each analysis on the points of a box or on all; null: not
 * yet. */
struct Results {
  std::shared_ptr<const std::vector<PointDistributionTensor>> tensors;
  std::shared_ptr<const MultiScaleShapes> shapes;
  std::shared_ptr<const GraphStore> graphs; ///< of the same run, if there is room
  std::shared_ptr<const CurveNetwork> curves;
  std::shared_ptr<const powerline::PowerLineNetwork> lines;
};

/** \brief Everything that views show and may change: cloud, fields, selection,
 * settings, results, and reviews of wires. Independent of any window. Belongs to one
 * thread; long work runs in others, whose results \ref poll takes over. */
class Model {
public:
  AnalysisSettings settings;

  /** \name Files
   * @{ */

  /** \brief Begins to open \a paths; see \ref openScene. */
  void
  open(const std::vector<std::string>& paths, const std::string& truth = {});

  /** \brief The open scene; empty before anything is opened. */
  const Scene&
  scene() const
  {
    return *scene_;
  }
  /** @} */

  /** \name Work in other threads
   * @{ */

  /** \brief Begins to compute \a analysis with the current settings, on the points in
   * the preview box if there is one.
   * \throws std::invalid_argument if there are no points */
  void
  compute(Analysis analysis);

  void
  cancel();

  /** \brief Whether work is running. */
  bool
  busy() const;

  Progress
  progress() const;

  /** \brief What may have changed since the last \ref poll. */
  struct Changes {
    bool scene = false, results = false, probe = false, image = false;
    std::string error; ///< a sentence to show; empty: none
  };

  /** \brief Takes over finished results. */
  Changes
  poll();

  /** \brief Polls until nothing runs; for scripts and tests. */
  Changes
  wait();

  const Results&
  results() const
  {
    return results_;
  }

  /** \brief Whether the result of \a analysis was computed with other settings. */
  bool
  stale(Analysis analysis) const;
  /** @} */

  /** \brief Limits computations to \a box; none: the whole cloud. */
  void
  setPreview(const std::optional<Box>& box);

  const std::optional<Box>&
  preview() const
  {
    return preview_;
  }

  /** \name What is shown
   * @{ */

  /** \brief What points can be colored by. */
  std::vector<std::string>
  fields() const;

  /** \brief The values of a field; NaN where there is none.
   * \throws std::invalid_argument for a name not in \ref fields */
  std::vector<float>
  values(const std::string& field) const;

  Coloring
  coloring(const std::string& field) const;

  /** \brief The computed curves, otherwise those that were opened. */
  const CurveNetwork&
  curves() const;

  /** \brief The computed power lines, otherwise those that were opened; null: none. */
  const powerline::PowerLineNetwork*
  lines() const;

  /** \brief A point of \ref lines in the coordinates of the cloud. */
  Point
  toCloud(const Point& of_network) const;
  /** @} */

  /** \name Selection
   * @{ */

  void
  select(std::optional<Index> point);

  std::optional<Index>
  selected() const
  {
    return selected_;
  }

  /** \brief The graphs at the selection; null until they are computed. */
  const PointGraphs*
  graphs() const
  {
    return graphs_.get();
  }

  /** \brief The tensor at the selection: at the radius of `tensor` if one is set,
   * otherwise at the point's optimal scale; none without a selection. */
  std::optional<PointDistributionTensor>
  tensorAtSelection() const;

  /** \brief Radius of that tensor; 0: none. */
  double
  tensorRadius() const;

  /** \brief Index in \ref curves, -1: none. */
  int curve = -1;
  /** @} */

  /** \name Multi-scale image
   * @{ */

  /** \brief Starts the image along \a line, with \a columns columns. */
  void
  imageAlong(Points line, std::size_t columns = 200);

  /** \brief Starts the image of the neighborhood of the selection, along e3. */
  void
  imageAround(std::size_t columns = 200);

  const ScaleImage*
  image() const
  {
    return image_.get();
  }
  /** @} */

  /** \name Wires
   * @{ */

  /** \brief Ids of the wires, the least certain first. */
  std::vector<int>
  wiresByConfidence() const;

  /** \brief The current wire, 0: none. */
  int
  wire() const
  {
    return wire_;
  }
  void
  selectWire(int id);

  /** \brief The review of wire \a id. */
  const powerline::Review&
  review(int id) const;

  /** \brief Reviews wire \a id, and saves the review at once.
   * \throws io::FileError if it cannot be saved; the review is kept all the same */
  void
  setReview(int id, const powerline::Review& review);

  /** \brief Where reviews are saved: in the folder, or beside the first input. */
  std::string
  reviewFile() const;

  /** \brief The network with all reviews applied. */
  powerline::PowerLineNetwork
  reviewed() const;
  /** @} */

  /** \brief The command that runs \a analysis without a window. */
  std::string
  commandLine(Analysis analysis) const;

  /** \brief All options of \a analysis as an option file; the preview box as bounds. */
  std::string
  config(Analysis analysis) const;

  /** \brief The displayed state, in numbers. */
  nlohmann::ordered_json
  state() const;

private:
  void
  adopt(std::shared_ptr<const Scene> scene);
  void
  adoptLines(std::shared_ptr<const powerline::PowerLineNetwork> lines);
  void
  beginGraphs();
  AnalysisSettings
  withPreview() const;
  std::string
  fingerprint(Analysis analysis) const;
  std::vector<powerline::ReviewedWire>
  reviewedWires() const;

  std::shared_ptr<const Scene> scene_ = std::make_shared<Scene>();
  Results results_;
  std::array<std::string, 4> computed_with_; // fingerprints of the results
  std::optional<Box> preview_;
  std::optional<Index> selected_;
  std::shared_ptr<const PointGraphs> graphs_;
  std::shared_ptr<const ScaleImage> image_;
  // Radii of the whole cloud, by the settings they depend on.
  struct KnownRadii {
    std::string of;
    std::vector<double> radii;
  };
  std::shared_ptr<const KnownRadii> known_radii_;
  int wire_ = 0;
  std::vector<powerline::Review> reviews_; // one per wire of lines()
  Changes changes_;
  Worker analysis_, probe_, imager_; // joined before anything it uses is destroyed
};

} // namespace linelet::view
