// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <linelet/clustering/cluster_points.h>
#include <linelet/features/tensor_record.h>
#include <linelet/io/mesh_file.h>
#include <linelet/io/output_file.h>
#ifdef LINELET_HAS_OPENCL
#include <linelet/opencl/cluster_engine.h>
#endif

#include "camera_file.h"
#include "cloud_files.h"
#include "commands.h"
#include "frame.h"
#include "options.h"

namespace linelet::apps {

namespace {

/** \brief Whether an attribute is a label rather than a measure: clusters then get its
 * most frequent value, otherwise the mean. */
bool
isName(const io::Column& column)
{
  constexpr std::array<std::string_view, 4> measures = {
      "intensity", "red", "green", "blue"};
  return !std::holds_alternative<std::vector<float>>(column.values) &&
         !std::holds_alternative<std::vector<double>>(column.values) &&
         std::find(measures.begin(), measures.end(), column.name) == measures.end();
}

std::vector<double>
valuesOf(const io::Column& column, std::size_t count)
{
  std::vector<double> values;
  values.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(io::valueAt(column, i));
  return values;
}

/** \brief \a column for the representatives, keeping its type. */
io::Column
reduced(const io::Column& column, const Clusters& clusters)
{
  const std::vector<double> all = valuesOf(column, clusters.cluster_of.size());
  const std::vector<double> values =
      isName(column) ? clusterModes(clusters, all) : clusterMeans(clusters, all);
  io::Column result{column.name, {}, column.description};
  std::visit(
      [&](const auto& typed) {
        using T = typename std::decay_t<decltype(typed)>::value_type;
        std::vector<T> out;
        out.reserve(values.size());
        for (const double value : values)
          if constexpr (std::is_floating_point_v<T>)
            out.push_back(static_cast<T>(value));
          else
            out.push_back(static_cast<T>(value + (value < 0 ? -0.5 : 0.5)));
        result.values = std::move(out);
      },
      column.values);
  return result;
}

/** \brief The representatives, with attributes of the points and of the clusters. */
io::Cloud
representatives(const io::Cloud& cloud, const Clusters& clusters)
{
  io::Cloud result;
  result.shift = cloud.shift;
  result.wkt = cloud.wkt;
  result.format = cloud.format;
  result.las = cloud.las;
  std::vector<std::uint32_t> counts;
  std::vector<PointDistributionTensor> records;
  for (const Representative& r : clusters.representatives) {
    result.points.push_back(r.center);
    counts.push_back(r.count);
    records.push_back(recordOf(r.tensor, 0, r.count));
  }
  for (std::size_t i = 0; i < clusters.normals.size(); ++i) {
    const Eigen::Vector3f normal = clusters.normals[i].cast<float>();
    records[i].normal_x = normal.x();
    records[i].normal_y = normal.y();
    records[i].normal_z = normal.z();
  }
  const char* const normals = clusters.normals.empty()
                                  ? "along the smallest extent"
                                  : "toward neighboring cells without points";
  for (const io::Column& column : cloud.columns)
    result.set(reduced(column, clusters));
  result.set({"count", std::move(counts), "points that it stands for"});
  using R = PointDistributionTensor;
  const auto add = [&](const char* name, float R::*member, const char* description) {
    addColumn(result, records, name, member, description);
  };
  add("xx", &R::xx, "covariance of the members");
  add("xy", &R::xy, "covariance of the members");
  add("xz", &R::xz, "covariance of the members");
  add("yy", &R::yy, "covariance of the members");
  add("yz", &R::yz, "covariance of the members");
  add("zz", &R::zz, "covariance of the members");
  add("normal_x", &R::normal_x, normals);
  add("normal_y", &R::normal_y, normals);
  add("normal_z", &R::normal_z, normals);
  add("linearity", &R::linearity, "shape factor CL, 0 to 1");
  add("planarity", &R::planarity, "shape factor CP, 0 to 1");
  add("sphericity", &R::sphericity, "shape factor CS, 0 to 1");
  return result;
}

std::vector<double>
fieldOf(const io::Cloud& cloud, const std::string& name, const std::string& file)
{
  if (const io::Column* column = cloud.find(name))
    return valuesOf(*column, cloud.points.size());
  std::string names;
  for (const io::Column& column : cloud.columns)
    names += " " + column.name;
  throw std::runtime_error(file + ": there is no field '" + name + "'; it has" +
                           (names.empty() ? " none" : names));
}

Clusters
clustersOf(const Points& points,
           const ClusterSettings& settings,
           const std::vector<double>& field,
           const std::string& device,
           Frame& frame)
{
  if (device.empty())
    return clusterPoints(points, settings, field, &frame.monitor);
#ifdef LINELET_HAS_OPENCL
  opencl::ClusterEngine engine(device == "auto" ? "" : device);
  frame.summary["device"] = engine.device().name;
  return engine.cluster(points, settings, field, &frame.monitor);
#else
  throw std::runtime_error("this linelet was built without OpenCL; omit --device");
#endif
}

/** \brief Fails before long work if a mesh could not be written to \a path after it. */
void
checkMeshOutput(const std::string& path)
{
  if (std::filesystem::path(path).extension() != ".ply")
    throw std::runtime_error(path + ": meshes are written as .ply");
  io::checkWritable(path);
}

} // namespace

int
runCluster(const std::vector<std::string>& arguments)
{
  Frame frame("cluster",
              "Thins a cloud to representatives: the means of points that share a cell "
              "of a grid, with their number, covariance, normal and shape factors; "
              "attributes become means, classes and other labels the most frequent "
              "one. Points near the border of a cell may first move to the cell "
              "across, so that the cells adapt to the objects in them.");
  ClusterSettings settings;
  std::string field, camera, device, mesh;
  CloudInput input(frame);
  CloudOutput output(frame);
  addOptions(frame.app, settings);
  const OptionAdder add(frame.app);
  add("field",
      field,
      "attribute by which points move, for example planarity: cells become purer in "
      "it");
  add("camera",
      camera,
      "JSON file with the eye and target of a camera: the cells fill its view, finer "
      "near it; needs --cells");
  add("device",
      device,
      "cluster on this OpenCL device, by number or part of its name, or auto; the "
      "result "
      "is the same");
  add("mesh",
      mesh,
      "write the --faces of the cells to this .ply, quads unless boxes are requested; "
      "part is the number of the representative in OUTPUT");
  frame.reads(camera);
  frame.writes(mesh);
  frame.parse(arguments);
  settings.threads = frame.threads;
  if (!field.empty())
    settings.move_by = MoveRule::Field;
  else if (settings.move_by == MoveRule::Field)
    throw std::runtime_error("--move-by field needs --field");
  if (mesh.empty() && settings.faces != CellFaces::None)
    throw std::runtime_error("--faces are written to --mesh FILE.ply; name one");
  if (!mesh.empty()) {
    if (settings.faces == CellFaces::None)
      settings.faces = CellFaces::Quads;
    checkMeshOutput(mesh);
  }
  output.check();

  const io::Cloud cloud = input.read();
  const io::UsablePoints usable = input.usable(cloud);
  if (!camera.empty())
    settings.camera = readCamera(camera, cloud.shift);
  const Clusters clusters = clustersOf(
      usable.points(),
      settings,
      field.empty() ? std::vector<double>{} : fieldOf(cloud, field, input.path()),
      device,
      frame);
  frame.lap("cluster");
  output.write(representatives(cloud, clusters));
  if (!mesh.empty())
    io::writeMesh(mesh, clusters.faces, cloud.shift);

  const auto outside = static_cast<std::size_t>(std::count(
      clusters.cluster_of.begin(), clusters.cluster_of.end(), Clusters::none));
  const std::size_t inside = cloud.points.size() - outside;
  std::printf("%s: %zu representatives of %zu points",
              output.path().c_str(),
              clusters.representatives.size(),
              inside);
  if (clusters.leaf > 0)
    std::printf(", cells of %.6g", clusters.leaf);
  std::printf(", grid of %lld x %lld x %lld\n",
              static_cast<long long>(clusters.cells[0]),
              static_cast<long long>(clusters.cells[1]),
              static_cast<long long>(clusters.cells[2]));
  if (outside > usable.leftOut())
    std::printf("%zu points are in no cell: not finite, or out of the camera's view\n",
                outside - usable.leftOut());
  frame.summary["points"] = cloud.points.size();
  frame.summary["clustered"] = inside;
  frame.summary["representatives"] = clusters.representatives.size();
  if (!mesh.empty())
    frame.summary["faces"] = clusters.faces.size();
  if (clusters.leaf > 0)
    frame.summary["leaf"] = clusters.leaf;
  frame.summary["cells"] = clusters.cells;
  frame.summary["move_by"] = nameOf(settings.move_by);
  frame.summary["moves"] = settings.moves;
  frame.summary["withheld"] = usable.withheld();
  frame.summary["ignored"] = usable.ignored();
  return frame.finish();
}

} // namespace linelet::apps
