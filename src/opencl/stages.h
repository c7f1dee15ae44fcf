// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <linelet/support/points.h>

#include "context.h"

namespace linelet::opencl {

/** \brief How the keys of points are made from their cells: KeyLayout of cells.cl. */
struct KeyLayout {
  cl_uint nx = 1, ny = 1; ///< cells along x and y
  cl_uint index_bits = 0; ///< the lowest bits, for the index of the point
};

/** \brief The cells of a cloud: as wide as the largest radius, two empty ones beyond
 * every point. */
struct CellFrame {
  Point corner = Point::Zero();
  double cell_size = 1;
  Eigen::Array3d cells = Eigen::Array3d::Constant(5); ///< along every axis

  CellFrame(const Points& points, const Indices& chosen, double radius);

  /** \brief Whether cells and \a count indices fit into a key of 64 bits. */
  bool
  fits(std::size_t count) const;

  KeyLayout
  layout(std::size_t count) const;

  cl_float
  cellSize() const
  {
    return static_cast<cl_float>(cell_size);
  }
};

/** \brief Points on the device: cell, position in the cell (float) and, if the device
 * supports double, the position itself. */
struct DevicePoints {
  cl_uint count = 0;
  cl::Buffer cells;     // int4
  cl::Buffer offsets;   // 3 floats
  cl::Buffer positions; // 3 doubles, a single byte without double precision
};

/** \brief Uploads the chosen points. */
DevicePoints
uploadPoints(Context& context,
             const Points& points,
             const Indices& chosen,
             const CellFrame& frame,
             int threads);

/** \brief Number of keys sorted at a time; the total is padded to a multiple of it. */
constexpr std::size_t sort_block = 2048;

/** \brief The keys of \a points, sorted, then largest keys up to a whole block. */
cl::Buffer
sortedKeys(Context& context,
           const DevicePoints& points,
           const CellFrame& frame,
           const KeyLayout& layout);

/** \brief Sorts \a count keys on the device, a multiple of \ref sort_block. */
void
sortKeys(Context& context, const cl::Buffer& keys, std::size_t count);

/** \brief The cells that hold a query, and where the points around them are stored. */
struct CellTable {
  static constexpr std::size_t rows = 9, row_places = 13; // of cells.cl

  cl_uint slots = 0;
  cl::Buffer query_slot; // slot of the query at a place
  cl::Buffer slot_place; // place of a slot's first query
  cl::Buffer places;     // rows x row_places per slot

  std::size_t
  bytes() const
  {
    return slots * rows * row_places * sizeof(cl_uint);
  }
};

/** \brief Gives the cells of queries their slots; the places are not filled in. */
CellTable
assignSlots(Context& context,
            const cl::Buffer& query_keys,
            std::size_t queries,
            const KeyLayout& layout);

/** \brief Fills in the places: for every row of cells around a slot, and every bin of
 * the row, its first point in sorted order, and after the last bin its end. */
void
fillTable(Context& context,
          CellTable& table,
          const cl::Buffer& query_keys,
          const cl::Buffer& point_keys,
          std::size_t points,
          const KeyLayout& layout);

/** \brief Points and queries on the device, and the table that connects them. */
struct Slab {
  CellFrame frame;
  KeyLayout layout;
  DevicePoints points, queries;
  cl::Buffer point_keys, query_keys; // sorted
  CellTable table;
};

} // namespace linelet::opencl
