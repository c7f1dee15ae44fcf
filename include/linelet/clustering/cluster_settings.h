// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <linelet/support/camera.h>
#include <linelet/support/names.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief When a point near the border of its cell goes to the cell across. */
enum class MoveRule {
  Plane,      ///< where it is nearer to the plane of that cell's members
  Population, ///< where that cell holds fewer points
  Field       ///< where that raises the mean of a field in both cells
};

template <>
struct Names<MoveRule> {
  static constexpr std::string_view kind = "move rule";
  static constexpr std::array<std::pair<MoveRule, std::string_view>, 3> table = {{
      {MoveRule::Plane, "plane"},
      {MoveRule::Population, "population"},
      {MoveRule::Field, "field"},
  }};
};

/** \brief Where the normals of representatives come from. */
enum class NormalRule {
  Tensor,    ///< the smallest extent of the members
  EmptyCells ///< toward the empty cells within two cells: for cells with few members,
             ///< oriented to the outside (Schiffner et al. 2015, without a formula;
             ///< here their mean direction, or for walls its axis)
};

template <>
struct Names<NormalRule> {
  static constexpr std::string_view kind = "normal rule";
  static constexpr std::array<std::pair<NormalRule, std::string_view>, 2> table = {{
      {NormalRule::Tensor, "tensor"},
      {NormalRule::EmptyCells, "empty-cells"},
  }};
};

/** \brief What is drawn in place of the points of a cell (Schiffner et al. 2015). */
enum class CellFaces {
  None,
  Quads, ///< the members' plane as far as their cell reaches: three to six corners
  Boxes  ///< the sides of the cell, without those between two cells that hold points
};

template <>
struct Names<CellFaces> {
  static constexpr std::string_view kind = "cell face";
  static constexpr std::array<std::pair<CellFaces, std::string_view>, 3> table = {{
      {CellFaces::None, "none"},
      {CellFaces::Quads, "quads"},
      {CellFaces::Boxes, "boxes"},
  }};
};

/** \brief The grid that points are clustered in, and how its cells adapt to them.
 *
 * Exactly one of \ref cells, \ref leaf and \ref count sets the resolution of the
 * grid. */
struct ClusterSettings {
  std::vector<double> cells; ///< number of cells along x, y and z; with a camera:
                             ///< across the picture, down, and in depth
  double leaf = 0;           ///< edge of cubic cells, unit of the points
  std::size_t count = 0;     ///< approximate number of representatives, of cubic cells
  unsigned moves = 2;        ///< how often points may move
  MoveRule move_by = MoveRule::Plane;
  double border = 0.5; ///< how near its cell's border a point must be to move, as a
                       ///< fraction (0, 0.5] of the cell's width
  NormalRule normals = NormalRule::Tensor;
  CellFaces faces = CellFaces::None;
  std::optional<Camera>
      camera;           ///< cells fill its view, finer near the eye; needs \ref cells
  unsigned threads = 0; ///< 0: all; the result is the same for any number
};

template <class Visit>
void
describe(ClusterSettings& s, Visit&& visit)
{
  visit("cells", s.cells, "number of cells along x, y and z");
  visit("leaf", s.leaf, "edge of cubic cells instead, in the unit of the cloud");
  visit("count",
        s.count,
        "approximate number of representatives instead, of cubic cells");
  visit("moves", s.moves, "how often points near a border may move to the cell across");
  visit("move-by", s.move_by, "what makes a point move");
  visit("border",
        s.border,
        "how near the border a point must be to move, in widths of its cell, at most "
        "0.5");
  visit("normals",
        s.normals,
        "direction of normals: along the smallest extent of the members, or toward the "
        "empty cells around");
  visit("faces",
        s.faces,
        "what represents the cells in a mesh: the plane of the members within their "
        "cell, or the sides of the cell");
}

/** \brief Checks that exactly one grid size is given and that it is valid.
 * \throws std::invalid_argument with the value and what is expected */
void
validate(const ClusterSettings& settings);

} // namespace linelet
