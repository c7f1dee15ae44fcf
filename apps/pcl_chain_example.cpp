// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <iostream>

#include <linelet/curves/eigen_streamline_curve_reconstruction.h>
#include <linelet/features/point_distribution_tensor.h>
#include <linelet/io/output_check.h>
#include <linelet/io/point_file.h>
#include <linelet/io/vector_file.h>
#include <pcl/filters/passthrough.h>
#include <pcl/filters/voxel_grid.h>
using Cloud = pcl::PointCloud<pcl::PointXYZI>;
int
main(int argc, char** argv)
try {
  if (argc != 3) {
    std::cerr << "usage: pcl_chain_example INPUT.las OUTPUT.geojson\n";
    return 2;
  }
  const auto file = linelet::io::readCloud(argv[1]); // shifted: small enough for float
  Cloud::Ptr cloud(new Cloud), thinned(new Cloud), lines(new Cloud);
  for (const auto& p : file.points)
    cloud->emplace_back(float(p.x()), float(p.y()), float(p.z()));
  pcl::VoxelGrid<pcl::PointXYZI> voxels;
  voxels.setInputCloud(cloud);
  voxels.setLeafSize(0.2f, 0.2f, 0.2f);
  voxels.filter(*thinned);
  linelet::PointDistributionTensorEstimation<pcl::PointXYZI> tensor;
  tensor.setInputCloud(thinned);
  tensor.setRadiusSearch(1.5);
  pcl::PointCloud<linelet::PointDistributionTensor> shapes;
  tensor.compute(shapes);
  for (std::size_t i = 0; i < shapes.size(); ++i)
    (*thinned)[i].intensity = shapes[i].linearity;
  pcl::PassThrough<pcl::PointXYZI> pass;
  pass.setInputCloud(thinned);
  pass.setFilterFieldName("intensity");
  pass.setFilterLimits(0.8f, 1.0f);
  pass.filter(*lines);
  linelet::EigenStreamlineCurveReconstruction<pcl::PointXYZI> reconstruction;
  reconstruction.setInputCloud(lines);
  pcl::PolygonMesh mesh; // one polygon per curve, for tools that work on meshes
  reconstruction.reconstruct(mesh);
  const linelet::CurveNetwork curves = reconstruction.reconstruct();
  if (linelet::io::isSameFile(argv[1], argv[2]))
    throw linelet::io::FileError(std::string(argv[2]) + ": is the input");
  linelet::io::writeCurves(argv[2], curves, file.shift, file.wkt);
}
catch (const std::exception& error) {
  std::cerr << "pcl_chain_example: " << error.what() << '\n';
  return 1;
}
