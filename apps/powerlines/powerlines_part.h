// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <linelet/fragments/pieces.h>
#include <linelet/io/cloud.h>
#include <linelet/powerline/network_part.h>
#include <linelet/powerline/surroundings.h>

namespace linelet::apps {

/** \brief What a fragment found out about a point that it owns. */
struct PointLabel {
  std::uint32_t fragment = 0;
  std::int32_t wire = 0; ///< id there
  std::uint8_t number_of_class = 0, unexplained = 0;
  std::uint16_t unused = 0;
};

/** \brief A point beside a wire, as pictures show it, or of a wire or support. */
struct PicturePoint {
  double x, y, z; ///< of the fragment
  std::int32_t wire;
  std::uint8_t number_of_class, unexplained;
  std::uint16_t unused;
};

/** \brief What stands near the lines, among the points that a fragment owns. */
struct OwnSurroundings {
  powerline::Surroundings all;
  std::vector<std::uint32_t> input, place; ///< of each point, by which they are ordered
};

/** \brief What a fragment contributes to power lines, besides the labels of its
 * points. */
struct PowerlinesPart {
  powerline::NetworkPart network;
  OwnSurroundings surroundings;
  std::vector<PicturePoint> picture;
};

/** \brief The points of \a fragment that are or surround the lines.
 * \param[in] most maximum number, evenly chosen; 0: no limit */
std::vector<PicturePoint>
picturePoints(const fragments::Fragment& fragment,
              const io::Cloud& cloud,
              const powerline::PowerLineNetwork& network,
              std::size_t most);

/** \brief Those of \a found whose points, of \a cloud, the fragment owns. */
OwnSurroundings
ownSurroundings(const fragments::Fragment& fragment,
                const io::Cloud& cloud,
                const powerline::Surroundings& found);

/** \brief Writes labels, part and terrain to \a result and files beside it.
 * \throws io::FileError */
void
savePart(const std::string& result,
         const fragments::Fragment& fragment,
         const powerline::PowerLineNetwork& network,
         PowerlinesPart part);

/** \throws io::FileError if it is missing or damaged */
PowerlinesPart
loadPart(const std::string& result);

/** \brief The terrain saved with it. \throws io::FileError */
powerline::Ground
loadGround(const std::string& result);

} // namespace linelet::apps
