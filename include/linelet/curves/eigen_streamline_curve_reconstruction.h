// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <pcl/memory.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/PolygonMesh.h>
#include <pcl/surface/reconstruction.h>
#include <pcl/Vertices.h>

#include <linelet/curves/curve_network.h>
#include <linelet/curves/reconstruct_curves.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Curves that run through a cloud: \ref reconstructCurves in a PCL pipeline.
 *
 * The full result is the \ref CurveNetwork of \ref reconstruct. The overloads of
 * pcl::SurfaceReconstruction return it as a PolygonMesh or as vertices, one polygon per
 * curve with its vertices in order; a closed curve repeats the index of its first
 * vertex. PCL's mesh writers fill polygons: write curves with linelet::io instead.
 *
 * Points that are not finite are left out. Without input, with an index beyond the
 * cloud, or with a parameter out of range, the result is empty, with a message through
 * PCL_ERROR; a cloud without a curve gives an empty result without a message. Neighbors
 * come from the search given by setSearchMethod (any of them; PCL hands a cloud to its
 * search only when the pointer changes, so never alter a cloud in place), else from a
 * built-in grid; the curves are the same up to rounding. Preset::Published takes all
 * neighbors from it, except those of points that a prefilter has moved; Preset::Refined
 * only those that measure the spacing of the points: see \ref reconstructRefined.
 *
 * Prebuilt for PointXYZ, PointXYZI, PointXYZRGB, PointNormal and PointXYZINormal. For
 * any other type define PCL_NO_PRECOMPILE before the first include, as for PCL's own
 * classes. */
template <typename PointInT>
class EigenStreamlineCurveReconstruction : public pcl::SurfaceReconstruction<PointInT> {
  using Base = pcl::SurfaceReconstruction<PointInT>;

public:
  using Ptr = pcl::shared_ptr<EigenStreamlineCurveReconstruction>;
  using ConstPtr = pcl::shared_ptr<const EigenStreamlineCurveReconstruction>;

  EigenStreamlineCurveReconstruction() { this->check_tree_ = false; }

  /** \brief Number of start points; 0 (default): as many as needed. */
  void
  setStartPoints(unsigned count)
  {
    settings_.start_points = count;
  }
  unsigned
  getStartPoints() const
  {
    return settings_.start_points;
  }

  /** \brief Steps per trace; 0 (default): automatic. */
  void
  setMaxIterations(unsigned count)
  {
    settings_.max_iterations = count;
  }
  unsigned
  getMaxIterations() const
  {
    return settings_.max_iterations;
  }

  /** \brief The widest gap to bridge, in the unit of the cloud; 0 (default):
   * automatic. */
  void
  setDistanceCutoff(double distance)
  {
    settings_.distance_cutoff = distance;
  }
  double
  getDistanceCutoff() const
  {
    return settings_.distance_cutoff;
  }

  void
  setPreset(Preset preset)
  {
    settings_.preset = preset;
  }
  Preset
  getPreset() const
  {
    return settings_.preset;
  }

  /** \brief 0: what OpenMP offers. The result is the same for any number. */
  void
  setNumberOfThreads(unsigned nr_threads = 0)
  {
    settings_.threads = nr_threads;
  }
  unsigned
  getNumberOfThreads() const
  {
    return settings_.threads;
  }

  /** \brief All parameters at once, including those of Preset::Published. */
  void
  setSettings(const ReconstructionSettings& settings)
  {
    settings_ = settings;
  }
  const ReconstructionSettings&
  getSettings() const
  {
    return settings_;
  }

  /** \brief Receives the progress of reconstruct and may cancel it, which throws \ref
   * Canceled. Null (default): none. It must outlive reconstruct. */
  void
  setProgressMonitor(ProgressMonitor* monitor)
  {
    monitor_ = monitor;
  }

  /** \brief The curves through the input points, or those that setIndices names. */
  CurveNetwork
  reconstruct();

  void
  reconstruct(pcl::PolygonMesh& output) override;

  void
  reconstruct(pcl::PointCloud<PointInT>& points,
              std::vector<pcl::Vertices>& polygons) override;

protected:
  using Base::deinitCompute;
  using Base::indices_;
  using Base::initCompute;
  using Base::input_;
  using Base::tree_;

  std::string
  getClassName() const override
  {
    return "EigenStreamlineCurveReconstruction";
  }

  void
  performReconstruction(pcl::PolygonMesh& output) override;

  void
  performReconstruction(pcl::PointCloud<PointInT>& points,
                        std::vector<pcl::Vertices>& polygons) override;

private:
  bool
  refuse(const char* reason) const;
  bool
  chosenPoints(Points& points, Indices& indices);
  CurveNetwork
  reconstruct(const Points& points, const Indices& indices);

  ReconstructionSettings settings_;
  ProgressMonitor* monitor_ = nullptr;
};

extern template class EigenStreamlineCurveReconstruction<pcl::PointXYZ>;
extern template class EigenStreamlineCurveReconstruction<pcl::PointXYZI>;
extern template class EigenStreamlineCurveReconstruction<pcl::PointXYZRGB>;
extern template class EigenStreamlineCurveReconstruction<pcl::PointNormal>;
extern template class EigenStreamlineCurveReconstruction<pcl::PointXYZINormal>;

} // namespace linelet

#ifdef PCL_NO_PRECOMPILE
#include <linelet/curves/impl/eigen_streamline_curve_reconstruction.hpp>
#endif
