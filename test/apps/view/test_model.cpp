// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "model_test.h"

#include <linelet/io/vector_file.h>

namespace {

using namespace linelet;
using namespace linelet::view;

using ModelTest = linelet::test::ModelTest;

bool
same(float a, float b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

// The graphs at a click are those of a run over the whole cloud, to the last bit.
TEST_F(ModelTest, GraphsAreThoseOfAWholeRun)
{
  open(writeWire());
  const Scene& scene = model.scene();
  MultiScaleSettings settings = model.settings.scales;
  settings.engine = ScaleEngine::Sweep;
  std::vector<ShapeGraph> graphs(scene.points.size());
  const MultiScaleShapes whole = multiScaleShapes(
      scene.points,
      scene.points,
      settings,
      [&](std::size_t i, const ShapeGraph& graph) { graphs[i] = graph; });
  for (const Index i : {0u, 300u, 599u, 700u, 1999u}) {
    model.select(i);
    model.wait();
    ASSERT_NE(model.graphs(), nullptr);
    EXPECT_EQ(model.graphs()->radii, whole.radii);
    ASSERT_EQ(model.graphs()->graph.size(), graphs[i].size());
    for (std::size_t k = 0; k < graphs[i].size(); ++k) {
      const ScaleShape &a = model.graphs()->graph[k], &b = graphs[i][k];
      EXPECT_TRUE(same(a.linearity, b.linearity) && same(a.planarity, b.planarity) &&
                  same(a.sphericity, b.sphericity) && same(a.major_x, b.major_x))
          << i << " " << k;
      EXPECT_EQ(a.neighbors, b.neighbors);
    }
    EXPECT_EQ(static_cast<int>(model.graphs()->scale), whole.shapes[i].scale);
    ASSERT_EQ(model.graphs()->spread.size(), whole.radii.size());
  }
}

// On the wire, neighbors agree that it is a line, so the deviation is small.
TEST_F(ModelTest, SpreadOfNeighborsIsAroundTheirMean)
{
  open(writeWire());
  model.select(300);
  model.wait();
  const PointGraphs& graphs = *model.graphs();
  const auto& spread = graphs.spread[graphs.scale];
  EXPECT_GT(spread.mean[0], 0.9);
  EXPECT_LT(spread.deviation[0], 0.1);
  EXPECT_NEAR(spread.mean[0] + spread.mean[1] + spread.mean[2], 1, 1e-6);
}

TEST_F(ModelTest, EveryAnalysisGivesFields)
{
  open(writeWire());
  for (const auto& [analysis, name] : Names<Analysis>::table) {
    model.compute(analysis);
    const Model::Changes changes = model.wait();
    EXPECT_EQ(changes.error, "") << name;
    EXPECT_TRUE(changes.results) << name;
    EXPECT_FALSE(model.stale(analysis)) << name;
  }
  for (const std::string& field : model.fields()) {
    EXPECT_EQ(model
                  .values(field == "multiscale.shape" ? "multiscale.linearity"
                          : field == "tensor.shape"   ? "tensor.linearity"
                          : field == "rgb"            ? "red"
                                                      : field)
                  .size(),
              2000u)
        << field;
    EXPECT_EQ(model.coloring(field).rgb.size(), 6000u) << field;
  }
  EXPECT_THROW(model.values("no such field"), std::invalid_argument);
}

// Only results that depend on a setting are out of date after a change.
TEST_F(ModelTest, OnlyDependentResultsAreStale)
{
  open(writeWire());
  for (const Analysis analysis : {Analysis::Tensor, Analysis::MultiScale}) {
    model.compute(analysis);
    model.wait();
  }
  model.settings.set(Analysis::Tensor, "radius", "0.8");
  EXPECT_TRUE(model.stale(Analysis::Tensor));
  EXPECT_FALSE(model.stale(Analysis::MultiScale));
  EXPECT_FALSE(model.stale(Analysis::Curves)); // was never computed
  model.settings.set(Analysis::Tensor, "radius", "0");
  EXPECT_FALSE(model.stale(Analysis::Tensor));
}

// Computed on a box, the result is that of the box alone, and the rest is unknown.
TEST_F(ModelTest, PreviewWorksOnTheBoxAlone)
{
  open(writeWire());
  Box box = model.scene().bounds;
  box.high.x() = box.low.x() + 5;
  model.setPreview(box);
  model.settings.set(Analysis::Tensor, "radius", "0.5");
  model.compute(Analysis::Tensor);
  model.wait();
  const std::vector<float> linearity = model.values("tensor.linearity");
  for (std::size_t i = 0; i < linearity.size(); ++i)
    if (!box.contains(model.scene().points[i])) {
      EXPECT_TRUE(std::isnan(linearity[i])) << i;
    }
  // The same as without the rest, none of which is within reach.
  const float preview = linearity[60];
  model.setPreview(std::nullopt);
  model.compute(Analysis::Tensor);
  model.wait();
  EXPECT_FLOAT_EQ(preview, model.values("tensor.linearity")[60]);
  model.setPreview(box);
  EXPECT_NE(model.commandLine(Analysis::Tensor).find("--bounds-3d="),
            std::string::npos);
  box.low = box.high = box.low - Point(100, 0, 0);
  model.setPreview(box);
  EXPECT_THROW(model.compute(Analysis::Tensor), std::invalid_argument);
}

TEST_F(ModelTest, CanceledWorkLeavesTheLastResult)
{
  open(writeWire());
  model.compute(Analysis::MultiScale);
  model.wait();
  const auto before = model.results().shapes;
  model.settings.set(Analysis::MultiScale, "growth", "linear");
  model.compute(Analysis::MultiScale);
  model.cancel();
  EXPECT_EQ(model.wait().error, "");
  EXPECT_EQ(model.results().shapes, before);
  EXPECT_FALSE(model.busy());
}

// Clicks may come faster than their results; the last one counts.
TEST_F(ModelTest, TheLastClickCounts)
{
  open(writeWire());
  for (Index i = 0; i < 40; ++i)
    model.select(i);
  model.wait();
  EXPECT_EQ(model.selected(), 39u);
  ASSERT_NE(model.graphs(), nullptr);
  model.select(std::nullopt);
  EXPECT_EQ(model.graphs(), nullptr);
  EXPECT_FALSE(model.tensorAtSelection());
}

TEST_F(ModelTest, ScaleImageHasAColumnAPlace)
{
  open(writeWire());
  model.imageAlong({{0, 10, 6}, {10, 10, 6}, {20, 10, 6}}, 21);
  EXPECT_TRUE(model.wait().image);
  ASSERT_NE(model.image(), nullptr);
  ASSERT_EQ(model.image()->columns.size(), 21u);
  EXPECT_NEAR(model.image()->along.back(), 20, 1e-9);
  EXPECT_NEAR((model.image()->places[15] - Point(15, 10, 6)).norm(), 0, 1e-9);
  EXPECT_THROW(model.imageAround(), std::invalid_argument);
  model.select(300);
  model.wait();
  model.imageAround(50);
  model.wait();
  EXPECT_GT(model.image()->columns.size(), 10u);
  EXPECT_TRUE(std::is_sorted(model.image()->along.begin(), model.image()->along.end()));
}

TEST_F(ModelTest, TensorAtTheSelectionIsAnEllipsoidAlongTheWire)
{
  open(writeWire());
  model.settings.set(Analysis::Tensor, "radius", "1");
  model.select(300);
  model.wait();
  const auto tensor = model.tensorAtSelection();
  ASSERT_TRUE(tensor);
  EXPECT_GT(tensor->linearity, 0.95F);
  EXPECT_GT(std::abs(tensor->major_x), 0.99F);
  std::size_t sum = 0;
  for (const std::size_t count : distanceHistogram(model.scene(), 300, 1, 10))
    sum += count;
  EXPECT_EQ(sum + 1, tensor->neighbors); // the point itself does not count
}

// Any file gives either an error in one sentence or a cloud that every view can show.
TEST_F(ModelTest, OddFilesAreRefusedOrShown)
{
  const std::string whole = writeWire();
  std::string bytes;
  {
    std::ifstream in(whole, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(in), {});
  }
  for (const std::string& bad : {write("cut.las", bytes.substr(0, bytes.size() / 2)),
                                 write("empty.las", ""),
                                 write("empty.gpkg", ""),
                                 path("missing.las")}) {
    model.open({bad});
    const std::string error = model.wait().error;
    EXPECT_NE(error.find(std::filesystem::path(bad).filename().string()),
              std::string::npos)
        << bad << ": " << error;
  }
  for (const std::string& odd : {write("one.xyz", "1 2 3\n"),
                                 write("same.xyz", "1 2 3\n1 2 3\n1 2 3\n1 2 3\n"),
                                 write("nan.xyz", "nan nan nan\n1e300 0 0\n"),
                                 write("two.xyz", "1 2 3\n4 5 6\n")}) {
    model.open({odd});
    model.wait();
    for (const auto& [analysis, name] : Names<Analysis>::table) {
      try {
        model.compute(analysis);
      }
      catch (const std::invalid_argument&) {
      }
      model.wait();
    }
    if (!model.scene().points.empty()) {
      model.select(0);
      model.wait();
      model.imageAlong({Point(0, 0, 0), Point(0, 0, 0)}, 3);
      model.wait();
    }
    for (const std::string& field : model.fields())
      model.coloring(field);
    EXPECT_FALSE(model.state().dump().empty());
  }
}

TEST_F(ModelTest, WorksWithNothingOpen)
{
  EXPECT_TRUE(model.fields().empty());
  EXPECT_TRUE(model.wiresByConfidence().empty());
  EXPECT_EQ(model.lines(), nullptr);
  EXPECT_THROW(model.compute(Analysis::Tensor), std::invalid_argument);
  EXPECT_EQ(model.commandLine(Analysis::Tensor), "linelet tensor INPUT tensor.las");
}

// Curves alone, with a cloud, and as truth.
TEST_F(ModelTest, CurvesComeWithAndWithoutACloud)
{
  CurveNetwork network;
  network.curves.emplace_back().points = {Point(0, 10, 6), Point(20, 10, 6)};
  const Point shift(500000, 5900000, 50);
  io::writeCurves(path("curve.obj"), network, shift);
  io::writeCurves(path("curve.gpkg"), network, shift);
  io::writeCurves(path("curve.csv"), network, shift);
  io::writeCurves(path("curve.ply"), network, shift);
  for (const char* name : {"curve.obj", "curve.gpkg", "curve.csv", "curve.ply"}) {
    open(path(name));
    ASSERT_EQ(model.curves().curves.size(), 1u) << name;
    EXPECT_EQ(model.curve, 0);
    EXPECT_LT(model.curves().curves[0].points[0].norm(), 100) << name;
  }
  const std::string wire = writeWire();
  model.open({wire, path("curve.obj")}, path("curve.gpkg"));
  EXPECT_EQ(model.wait().error, "");
  EXPECT_EQ(model.scene().points.size(), 2000u);
  const Point world = model.curves().curves[0].points[0] + model.scene().cloud.shift;
  EXPECT_NEAR((world - shift - Point(0, 10, 6)).norm(), 0, 1e-3);
  EXPECT_EQ(model.scene().truth.curves.size(), 1u);
}

} // namespace
