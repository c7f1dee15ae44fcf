// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <vector>

#include <pcl/filters/filter.h>
#include <pcl/memory.h>
#include <pcl/point_types.h>

#include <linelet/clustering/cluster_points.h>
#include <linelet/support/progress_monitor.h>
#include <linelet/support/visibility.h>

namespace LINELET_PUBLIC linelet {

/** \brief Thins a cloud to representatives of the cells of a curvilinear grid: \ref
 * clusterPoints in a PCL pipeline, in place of pcl::VoxelGrid.
 *
 * One of \ref setLeafSize, \ref setGrid and \ref setCount sets the resolution of the
 * grid, which begins at the lower corner of the points' bounding box. The output has
 * one point per representative: the mean of its members, other fields of the point type
 * averaged as in pcl::CentroidPoint. It is dense and not organized. Points that are not
 * finite, or not in the camera's view, have no representative; they are reported as
 * removed indices on request. For invalid settings, filter gives an empty output and a
 * message through PCL_ERROR.
 *
 * Prebuilt for PointXYZ, PointXYZI, PointXYZRGB, PointNormal and PointXYZINormal. For
 * any other type define PCL_NO_PRECOMPILE before the first include. */
template <typename PointT>
class CurvilinearGridClustering : public pcl::Filter<PointT> {
  using Base = pcl::Filter<PointT>;

public:
  using Ptr = pcl::shared_ptr<CurvilinearGridClustering>;
  using ConstPtr = pcl::shared_ptr<const CurvilinearGridClustering>;
  using PointCloud = typename Base::PointCloud;

  /** \param[in] extract_removed_indices see pcl::Filter */
  explicit CurvilinearGridClustering(bool extract_removed_indices = false);

  /** \brief Edge of cubic cells, in the unit of the cloud. */
  void
  setLeafSize(double leaf)
  {
    settings_.leaf = leaf;
    settings_.cells.clear();
    settings_.count = 0;
  }
  double
  getLeafSize() const
  {
    return settings_.leaf;
  }

  /** \brief Number of cells along each axis of the box, or of the camera's view. */
  void
  setGrid(int x, int y, int z)
  {
    settings_.cells = {
        static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
    settings_.leaf = 0;
    settings_.count = 0;
  }
  const std::vector<double>&
  getGrid() const
  {
    return settings_.cells;
  }

  /** \brief Approximate number of representatives, of cubic cells. */
  void
  setCount(std::size_t count)
  {
    settings_.count = count;
    settings_.leaf = 0;
    settings_.cells.clear();
  }
  std::size_t
  getCount() const
  {
    return settings_.count;
  }

  /** \brief How often points may move to the cell across their nearest border, 2 by
   * default; 0: the cells are boxes. */
  void
  setMoves(unsigned moves)
  {
    settings_.moves = moves;
  }
  unsigned
  getMoves() const
  {
    return settings_.moves;
  }

  /** \brief What makes them move, by default the planes of the members. */
  void
  setMoveRule(MoveRule rule)
  {
    settings_.move_by = rule;
  }
  MoveRule
  getMoveRule() const
  {
    return settings_.move_by;
  }

  /** \brief A value for every point of the input cloud, whatever the indices, for
   * MoveRule::Field. */
  void
  setField(std::vector<double> field)
  {
    field_ = std::move(field);
  }

  /** \brief Cells fill the view of a camera, in the frame of the cloud; needs \ref
   * setGrid. */
  void
  setCamera(const Camera& camera)
  {
    settings_.camera = camera;
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

  void
  setSettings(const ClusterSettings& settings)
  {
    settings_ = settings;
  }
  const ClusterSettings&
  getSettings() const
  {
    return settings_;
  }

  /** \brief May cancel filter, which then throws linelet::Canceled. Null (default):
   * none. It must outlive filter. */
  void
  setProgressMonitor(ProgressMonitor* monitor)
  {
    monitor_ = monitor;
  }

  /** \brief Result of the last filter: count, center and covariance of every point of
   * the output, in its order, and the representative of every point of the input,
   * Clusters::none for points that are not among the indices or were removed. */
  const Clusters&
  getClusters() const
  {
    return clusters_;
  }

protected:
  using Base::extract_removed_indices_;
  using Base::filter_name_;
  using Base::indices_;
  using Base::input_;
  using Base::removed_indices_;

  /** \brief The clusters of \a points; other engines override this. */
  virtual Clusters
  cluster(const Points& points, const std::vector<double>& field);

private:
  void
  applyFilter(PointCloud& output) override;

  ClusterSettings settings_;
  ProgressMonitor* monitor_ = nullptr;
  std::vector<double> field_;
  Clusters clusters_;
};

extern template class CurvilinearGridClustering<pcl::PointXYZ>;
extern template class CurvilinearGridClustering<pcl::PointXYZI>;
extern template class CurvilinearGridClustering<pcl::PointXYZRGB>;
extern template class CurvilinearGridClustering<pcl::PointNormal>;
extern template class CurvilinearGridClustering<pcl::PointXYZINormal>;

} // namespace linelet

#ifdef PCL_NO_PRECOMPILE
#include <linelet/clustering/impl/curvilinear_grid_clustering.hpp>
#endif
