// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <linelet/curves/curve_network.h>
#include <linelet/io/cloud.h>
#include <linelet/support/points.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace linelet {
namespace LINELET_PUBLIC io {

// clang-format off
// HDF5 files (.h5) in the layout of a fiber bundle (Benger 2004), in the manner of F5:
//
//   /t=0                                     a time slice, attribute Time
//     /points                                a grid
//       /Points/StandardCartesianChart3D     its vertices in a chart; attributes shift
//                                            (three numbers to be added) and wkt
//         Positions                          compound x, y, z of doubles
//         NAME                               an attribute of every point; xx to zz
//                                            are one compound, a tensor
//         Fragments                          compound first, count, low, high: the
//                                            points of each block, and its box
//       /LAS                                 what a LAS file keeps besides its points
//     /curves                                another grid: polylines
//       /Points/StandardCartesianChart3D     Positions of their vertices
//       /Lines                               first, count, closed, ... of each polyline
//       /Junctions                           Positions, and the curves that meet there
//
// All datasets are chunked, shuffled and deflated. Where linelet was built without HDF5
// these functions throw FileError.
// clang-format on

/** \brief Whether linelet was built with HDF5. */
bool
hasHdf5();

/** \brief Writes a cloud block by block, with memory for one block. The file exists
 * once \ref commit returns, complete, and not before. */
class Hdf5CloudWriter {
public:
  /** \param[in] like the attributes (names, types, descriptions), shift, reference
   * system and LAS metadata that all blocks share; its values are ignored
   * \throws FileError */
  Hdf5CloudWriter(const std::string& path, const Cloud& like);
  ~Hdf5CloudWriter();
  Hdf5CloudWriter(const Hdf5CloudWriter&) = delete;
  Hdf5CloudWriter&
  operator=(const Hdf5CloudWriter&) = delete;

  /** \brief Adds the points of \a block as a fragment.
   * \throws FileError if its attributes are not those of the others */
  void
  append(const Cloud& block);

  /** \brief Adds \a count points of \a cloud from \a first on. */
  void
  append(const Cloud& cloud, std::size_t first, std::size_t count);

  /** \brief Adds curves, as a separate grid. At most once. */
  void
  add(const CurveNetwork& network, const Point& shift);

  void
  commit();

private:
  struct File;
  std::unique_ptr<File> file_;
};

/** \brief A run of points that was written at once. */
struct Hdf5Fragment {
  std::uint64_t first = 0, count = 0;
  Point low = Point::Zero(), high = Point::Zero(); ///< of its finite points, world
};

/** \brief The fragments of a file, in order; a single one if it lists none.
 * \throws FileError */
std::vector<Hdf5Fragment>
hdf5Fragments(const std::string& path);

/** \brief Reads \a count points from \a first on, with all attributes.
 * \throws FileError also if there are fewer */
Cloud
readHdf5Points(const std::string& path,
               std::size_t first,
               std::size_t count,
               std::vector<std::string>* warnings = nullptr);

/** \brief Writes \a cloud and \a network into one file. \throws FileError, Canceled */
void
writeHdf5(const std::string& path,
          const Cloud& cloud,
          const CurveNetwork& network,
          ProgressMonitor* monitor = nullptr);

/** \brief Writes \a network alone, with \a shift, which readers add.
 * \throws FileError */
void
writeHdf5Curves(const std::string& path,
                const CurveNetwork& network,
                const Point& shift = Point::Zero(),
                const std::string& wkt = {});

/** \brief The curves of a file in world coordinates, junctions and kinds of ends
 * included.
 * \param[out] wkt its reference system; may be null
 * \throws FileError if it holds none */
CurveNetwork
readHdf5Curves(const std::string& path, std::string* wkt = nullptr);

} // namespace io
} // namespace linelet
