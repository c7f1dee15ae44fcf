// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <linelet/fragments/plan.h>
#include <linelet/io/cloud.h>
#include <linelet/powerline/network_part.h>
#include <linelet/powerline/surroundings.h>
#include <linelet/powerline_output/class_scheme.h>

#include "classified_copy.h"
#include "cloud_files.h"

namespace linelet::apps {

struct PicturePoint;
struct OwnSurroundings;
struct PointLabel;

/** \brief The power lines of all fragments, merged. */
class PowerlinesMerge {
public:
  /** \param[in] usable which fragments exist
   * \param[in] wkt reference system of all
   * \throws io::FileError if a result is missing or damaged */
  PowerlinesMerge(const fragments::Plan& plan,
                  std::string folder,
                  std::vector<bool> usable,
                  const std::string& wkt);

  /** \brief The network, with its terrain; labels refer to \ref pictures. */
  const powerline::PowerLineNetwork&
  network() const
  {
    return network_;
  }

  /** \brief Points of the lines and beside them. */
  const io::Cloud&
  pictures() const
  {
    return pictures_;
  }

  /** \brief What stands near the lines, in the order of the inputs. */
  const powerline::Surroundings&
  surroundings() const
  {
    return surroundings_;
  }

  /** \brief Writes all inputs as one classified cloud. */
  CopiedPoints
  writeClassified(const std::string& path,
                  CloudInput& input,
                  const powerline::ClassScheme& classes,
                  std::vector<std::string>* warnings,
                  ProgressMonitor* monitor) const;

private:
  void
  addPictures(std::size_t fragment, const std::vector<PicturePoint>& points);
  void
  addSurroundings(const OwnSurroundings& own,
                  const powerline::PartIds& ids,
                  const std::uint32_t* ranks);
  void
  joinTerrain();
  void
  label(const io::Cloud& cloud,
        const std::vector<PointLabel>& labels,
        powerline::PowerLineNetwork& found) const;

  const fragments::Plan& plan_;
  std::string folder_;
  std::vector<bool> usable_;
  powerline::PowerLineNetwork network_;
  std::vector<powerline::PartIds> ids_; ///< by fragment
  powerline::Surroundings surroundings_;
  io::Cloud pictures_;
};

} // namespace linelet::apps
