// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

// The neighborhood tensor compared with PCL's own normals on the points of a file.
//
//   tensor_against_normals FILE [RADIUS [THREADS [REPETITIONS]]]
//
// Both start from the same cloud and find the same neighbors; the time includes the
// construction of the search structure. The fastest repetition counts.

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include <pcl/features/impl/normal_3d.hpp>
#include <pcl/features/impl/normal_3d_omp.hpp>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/search/kdtree.h>

#include <linelet/features/point_distribution_tensor.h>
#include <linelet/io/point_file.h>

#include "best_time.h"

namespace {

using namespace linelet;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

template <class Work>
bench::BestTime
fastest(int repetitions, Work work)
{
  bench::BestTime best;
  for (int i = 0; i < repetitions; ++i)
    best.run(work);
  return best;
}

void
compare(const std::string& file, double radius, unsigned threads, int repetitions)
{
  auto cloud = pcl::make_shared<Cloud>();
  for (const Point& point : io::readCloud(file).points)
    cloud->emplace_back(static_cast<float>(point.x()),
                        static_cast<float>(point.y()),
                        static_cast<float>(point.z()));
  std::printf(
      "%zu points, radius %g, %u threads (0: all)\n", cloud->size(), radius, threads);
  const auto report = [](const char* name, const bench::BestTime& time) {
    std::printf("%-22s wall %7.3f s  cpu %7.3f s\n", name, time.wall, time.cpu);
  };

  const bench::BestTime normals = fastest(repetitions, [&] {
    pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimation(threads);
    estimation.setInputCloud(cloud);
    estimation.setSearchMethod(
        pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>(false));
    estimation.setRadiusSearch(radius);
    pcl::PointCloud<pcl::Normal> output;
    estimation.compute(output);
  });
  report("NormalEstimationOMP", normals);
  for (const Engine engine : {Engine::Grid, Engine::Tree}) {
    const bench::BestTime tensor = fastest(repetitions, [&] {
      PointDistributionTensorEstimation<pcl::PointXYZ> estimation;
      estimation.setInputCloud(cloud);
      estimation.setNumberOfThreads(threads);
      estimation.setRadiusSearch(radius);
      estimation.setEngine(engine);
      pcl::PointCloud<PointDistributionTensor> output;
      estimation.compute(output);
    });
    report(engine == Engine::Grid ? "tensor, grid" : "tensor, tree", tensor);
    std::printf("%-22s wall %7.2f    cpu %7.2f\n",
                "  times as fast",
                normals.wall / tensor.wall,
                normals.cpu / tensor.cpu);
  }
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc < 2) {
    std::fprintf(stderr,
                 "tensor_against_normals FILE [RADIUS [THREADS [REPETITIONS]]]\n");
    return 2;
  }
  try {
    compare(argv[1],
            argc > 2 ? std::atof(argv[2]) : 1,
            argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : 0,
            argc > 4 ? std::atoi(argv[4]) : 3);
  }
  catch (const std::exception& error) {
    std::fprintf(stderr, "tensor_against_normals: %s\n", error.what());
    return 1;
  }
  return 0;
}
