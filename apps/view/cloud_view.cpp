// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "cloud_view.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <QMouseEvent>
#include <QTimer>
#include <QWheelEvent>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkLookupTable.h>
#include <vtkOutlineSource.h>
#include <vtkPointData.h>
#include <vtkPointGaussianMapper.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkTensorGlyph.h>
#include <vtkUnsignedCharArray.h>

#include "picture/color.h"

namespace linelet::view {

namespace {

constexpr std::size_t most_moving = 200000; ///< points drawn while the view moves
constexpr std::size_t most_ellipsoids = 3000;
constexpr double reach = 6; ///< pixels around a click

template <class T>
using Ptr = vtkSmartPointer<T>;

/** \brief A cloud of dots that takes positions and colors. */
struct Dots {
  Ptr<vtkPolyData> data = Ptr<vtkPolyData>::New();
  Ptr<vtkActor> actor = Ptr<vtkActor>::New();
  Indices indices; ///< points of the cloud, those with a place

  Dots()
  {
    const auto mapper = Ptr<vtkPointGaussianMapper>::New();
    mapper->SetInputData(data);
    mapper->SetScaleFactor(0); // dots of the actor's size in pixels
    mapper->EmissiveOff();
    mapper->SetScalarModeToUsePointData();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->PickableOff();
  }

  void
  place(const Points& points, Indices chosen)
  {
    indices = std::move(chosen);
    indices.erase(std::remove_if(indices.begin(),
                                 indices.end(),
                                 [&](Index i) { return !points[i].allFinite(); }),
                  indices.end());
    const auto coordinates = Ptr<vtkFloatArray>::New();
    coordinates->SetNumberOfComponents(3);
    coordinates->SetNumberOfTuples(static_cast<vtkIdType>(indices.size()));
    float* to = coordinates->GetPointer(0);
    for (const Index i : indices)
      for (int axis = 0; axis < 3; ++axis)
        *to++ = static_cast<float>(points[i][axis]);
    const auto vtk_points = Ptr<vtkPoints>::New();
    vtk_points->SetData(coordinates);
    data->SetPoints(vtk_points);
    data->GetPointData()->SetScalars(nullptr);
  }

  void
  color(const std::vector<std::uint8_t>& rgb)
  {
    const auto colors = Ptr<vtkUnsignedCharArray>::New();
    colors->SetNumberOfComponents(3);
    colors->SetNumberOfTuples(static_cast<vtkIdType>(indices.size()));
    unsigned char* to = colors->GetPointer(0);
    for (const Index i : indices)
      for (std::size_t c = 0; c < 3; ++c)
        *to++ = rgb[3 * static_cast<std::size_t>(i) + c];
    data->GetPointData()->SetScalars(colors);
    data->Modified();
  }
};

/** \brief Polylines, each in a color of its own. */
struct Lines {
  Ptr<vtkPolyData> data = Ptr<vtkPolyData>::New();
  Ptr<vtkActor> actor = Ptr<vtkActor>::New();
  Ptr<vtkPoints> points;
  Ptr<vtkCellArray> cells;
  Ptr<vtkUnsignedCharArray> colors;

  explicit Lines(double width)
  {
    const auto mapper = Ptr<vtkPolyDataMapper>::New();
    mapper->SetInputData(data);
    mapper->SetScalarModeToUseCellData();
    // In front of the points beside them.
    mapper->SetResolveCoincidentTopologyToPolygonOffset();
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-2, -200);
    actor->SetMapper(mapper);
    actor->GetProperty()->SetLineWidth(static_cast<float>(width));
    actor->GetProperty()->LightingOff();
    clear();
  }

  void
  clear()
  {
    points = Ptr<vtkPoints>::New();
    points->SetDataTypeToDouble();
    cells = Ptr<vtkCellArray>::New();
    colors = Ptr<vtkUnsignedCharArray>::New();
    colors->SetNumberOfComponents(3);
  }

  void
  add(const Points& line, bool closed, const apps::Color& color)
  {
    if (line.size() < 2)
      return;
    cells->InsertNextCell(static_cast<int>(line.size() + (closed ? 1 : 0)));
    const vtkIdType first = points->GetNumberOfPoints();
    for (const Point& p : line)
      cells->InsertCellPoint(points->InsertNextPoint(p.x(), p.y(), p.z()));
    if (closed)
      cells->InsertCellPoint(first);
    colors->InsertNextTuple3(255 * color[0], 255 * color[1], 255 * color[2]);
  }

  void
  done()
  {
    data->SetPoints(points);
    data->SetLines(cells);
    data->GetCellData()->SetScalars(colors);
    data->Modified();
  }
};

/** \brief The ellipsoids of tensors: half axes are square roots of eigenvalues. */
struct Ellipsoids {
  Ptr<vtkPolyData> data = Ptr<vtkPolyData>::New();
  Ptr<vtkTensorGlyph> glyph = Ptr<vtkTensorGlyph>::New();
  Ptr<vtkActor> actor = Ptr<vtkActor>::New();
  Ptr<vtkPoints> points;
  Ptr<vtkDoubleArray> tensors;
  Ptr<vtkFloatArray> linearity;

  Ellipsoids()
  {
    const auto sphere = Ptr<vtkSphereSource>::New();
    sphere->SetRadius(1);
    sphere->SetThetaResolution(20);
    sphere->SetPhiResolution(14);
    glyph->SetInputData(data);
    glyph->SetSourceConnection(sphere->GetOutputPort());
    glyph->ExtractEigenvaluesOn();
    glyph->ColorGlyphsOn();
    glyph->SetColorModeToScalars();
    const auto mapper = Ptr<vtkPolyDataMapper>::New();
    mapper->SetInputConnection(glyph->GetOutputPort());
    mapper->SetScalarRange(0, 1);
    const auto table = Ptr<vtkLookupTable>::New();
    table->SetNumberOfTableValues(256);
    for (int i = 0; i < 256; ++i) {
      const apps::Color c = apps::scalarColor(i / 255.0);
      table->SetTableValue(i, c[0], c[1], c[2], 1);
    }
    mapper->SetLookupTable(table);
    actor->SetMapper(mapper);
    clear();
  }

  void
  clear()
  {
    points = Ptr<vtkPoints>::New();
    tensors = Ptr<vtkDoubleArray>::New();
    tensors->SetNumberOfComponents(9);
    linearity = Ptr<vtkFloatArray>::New();
  }

  void
  add(const Point& at, const PointDistributionTensor& t)
  {
    if (std::isnan(t.linearity))
      return;
    Eigen::Matrix3d tensor;
    tensor << t.xx, t.xy, t.xz, t.xy, t.yy, t.yz, t.xz, t.yz, t.zz;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(tensor);
    // A floor, so that a flat ellipsoid still has a surface to light.
    const Eigen::Vector3d axes =
        solver.eigenvalues().cwiseMax(1e-4 * solver.eigenvalues()[2]).cwiseSqrt();
    const Eigen::Matrix3d root =
        solver.eigenvectors() * axes.asDiagonal() * solver.eigenvectors().transpose();
    points->InsertNextPoint(at.x(), at.y(), at.z());
    tensors->InsertNextTuple(root.data());
    linearity->InsertNextValue(t.linearity);
  }

  void
  done()
  {
    data->SetPoints(points);
    data->GetPointData()->SetTensors(tensors);
    data->GetPointData()->SetScalars(linearity);
    data->Modified();
    actor->SetVisibility(points->GetNumberOfPoints() > 0 ? 1 : 0);
  }
};

Point
pointOf(const double* xyz)
{
  return {xyz[0], xyz[1], xyz[2]};
}

} // namespace

struct CloudView::Actors {
  Ptr<vtkGenericOpenGLRenderWindow> window = Ptr<vtkGenericOpenGLRenderWindow>::New();
  Ptr<vtkRenderer> renderer = Ptr<vtkRenderer>::New();
  Dots all, part;
  Lines curves{2}, chosen{5}, marks{2};
  Ellipsoids ellipsoids, own;
  bool moving = false, everywhere = false;
};

CloudView::CloudView(const Model& model, QWidget* parent)
    : QVTKOpenGLNativeWidget(parent),
      model_(model),
      actors_(std::make_unique<Actors>()),
      still_(new QTimer(this))
{
  actors_->renderer->SetBackground(0.97, 0.97, 0.98);
  for (vtkActor* actor : {actors_->all.actor.Get(),
                          actors_->part.actor.Get(),
                          actors_->curves.actor.Get(),
                          actors_->chosen.actor.Get(),
                          actors_->marks.actor.Get(),
                          actors_->ellipsoids.actor.Get(),
                          actors_->own.actor.Get()})
    actors_->renderer->AddActor(actor);
  actors_->ellipsoids.done();
  actors_->own.done();
  actors_->window->SetMultiSamples(0);
  actors_->window->AddRenderer(actors_->renderer);
  setRenderWindow(actors_->window);
  still_->setSingleShot(true);
  still_->setInterval(300);
  connect(still_, &QTimer::timeout, [this] { setMoving(false); });
  setMoving(false);
}

CloudView::~CloudView() = default;

void
CloudView::showScene()
{
  const Points& points = model_.scene().cloud.points;
  actors_->all.place(points, randomSubset(points.size(), points.size()));
  actors_->part.place(points, randomSubset(points.size(), most_moving));
  drawn_line.clear();
  actors_->everywhere = false;
  showLines();
  showSelection();
  showAll();
}

void
CloudView::setColoring(const Coloring& coloring)
{
  if (coloring.rgb.size() == 3 * model_.scene().cloud.points.size()) {
    actors_->all.color(coloring.rgb);
    actors_->part.color(coloring.rgb);
  }
  actors_->window->Render();
}

void
CloudView::setPointSize(double pixels)
{
  for (Dots* dots : {&actors_->all, &actors_->part})
    dots->actor->GetProperty()->SetPointSize(static_cast<float>(pixels));
  actors_->window->Render();
}

void
CloudView::showLines()
{
  using Verdict = powerline::Review::Verdict;
  constexpr apps::Color found = {0.0, 0.35, 0.75}, doubtful = {0.95, 0.55, 0.0},
                        accepted = {0.05, 0.6, 0.25}, rejected = {0.75, 0.75, 0.78},
                        curve = {0.75, 0.1, 0.55}, truth = {0.1, 0.1, 0.1},
                        support = {0.3, 0.3, 0.35}, mark = {1.0, 0.1, 0.6},
                        unexplained = {0.85, 0.1, 0.1};
  Lines &lines = actors_->curves, &chosen = actors_->chosen;
  lines.clear();
  chosen.clear();
  for (const Curve& one : model_.scene().truth.curves)
    lines.add(one.points, one.closed, truth);
  const CurveNetwork& curves = model_.curves();
  for (std::size_t i = 0; i < curves.curves.size(); ++i)
    (static_cast<int>(i) == model_.curve ? chosen : lines)
        .add(curves.curves[i].points,
             curves.curves[i].closed,
             static_cast<int>(i) == model_.curve ? mark : curve);
  if (const auto* network = model_.lines(); network != nullptr) {
    for (const powerline::Wire& wire : network->wires) {
      Points line = powerline::polyline(wire, 0.02);
      for (Point& p : line)
        p = model_.toCloud(p);
      const Verdict verdict = model_.review(wire.id).verdict;
      const apps::Color& color = verdict == Verdict::Accepted   ? accepted
                                 : verdict == Verdict::Rejected ? rejected
                                 : wire.reason.empty()          ? found
                                                                : doubtful;
      const bool is_chosen = wire.id == model_.wire();
      (is_chosen ? chosen : lines).add(line, false, is_chosen ? mark : color);
    }
    for (const powerline::UnexplainedLine& one : network->unexplained) {
      Points line = one.course;
      for (Point& p : line)
        p = model_.toCloud(p);
      lines.add(line, false, unexplained);
    }
    for (const powerline::Support& one : network->supports)
      lines.add({model_.toCloud(one.base), model_.toCloud(one.top)}, false, support);
  }
  lines.done();
  chosen.done();
  actors_->window->Render();
}

void
CloudView::showSelection()
{
  Lines& marks = actors_->marks;
  marks.clear();
  actors_->own.clear();
  constexpr apps::Color red = {0.9, 0.1, 0.1}, gray = {0.4, 0.4, 0.45};
  if (const auto selected = model_.selected()) {
    const Point at = model_.scene().cloud.points[*selected];
    const double size = model_.tensorRadius() > 0       ? model_.tensorRadius()
                        : model_.scene().scale_unit > 0 ? 5 * model_.scene().scale_unit
                                                        : 1;
    for (int axis = 0; axis < 3; ++axis) {
      const Point arm = size * Point::Unit(axis);
      marks.add({at - arm, at + arm}, false, red);
    }
    if (const auto tensor = model_.tensorAtSelection())
      actors_->own.add(at, *tensor);
  }
  if (const auto& box = model_.preview()) {
    const auto corner = [&](int i) {
      return Point((i & 1 ? box->high : box->low).x(),
                   (i & 2 ? box->high : box->low).y(),
                   (i & 4 ? box->high : box->low).z());
    };
    for (int i = 0; i < 8; ++i)
      for (const int bit : {1, 2, 4})
        if ((i & bit) == 0)
          marks.add({corner(i), corner(i | bit)}, false, gray);
  }
  marks.add(drawn_line, false, red);
  marks.done();
  actors_->own.done();
  actors_->window->Render();
}

void
CloudView::showEllipsoids(bool everywhere)
{
  actors_->everywhere = everywhere;
  actors_->ellipsoids.clear();
  const auto& tensors = model_.results().tensors;
  if (everywhere && tensors != nullptr) {
    Indices known;
    for (std::size_t i = 0; i < tensors->size(); ++i)
      if (!std::isnan((*tensors)[i].linearity))
        known.push_back(static_cast<Index>(i));
    for (const Index k : randomSubset(known.size(), most_ellipsoids))
      actors_->ellipsoids.add(model_.scene().cloud.points[known[k]],
                              (*tensors)[known[k]]);
  }
  actors_->ellipsoids.done();
  actors_->window->Render();
}

void
CloudView::look(double azimuth, double elevation)
{
  vtkCamera* camera = actors_->renderer->GetActiveCamera();
  const double a = azimuth / 57.29577951308232,
               e = std::clamp(elevation, -89.9, 89.9) / 57.29577951308232;
  const Point back(-std::sin(a) * std::cos(e), -std::cos(a) * std::cos(e), std::sin(e));
  const Point eye = pointOf(camera->GetFocalPoint()) + camera->GetDistance() * back;
  camera->SetPosition(eye.x(), eye.y(), eye.z());
  camera->SetViewUp(0, 0, 1);
  moved();
}

void
CloudView::lookAt(const Point& place, double radius)
{
  vtkCamera* camera = actors_->renderer->GetActiveCamera();
  const Point direction = pointOf(camera->GetDirectionOfProjection());
  const double half_angle = camera->GetViewAngle() / 2 / 57.29577951308232;
  const Point eye = place - std::max(radius, 1e-6) / std::sin(half_angle) * direction;
  camera->SetFocalPoint(place.x(), place.y(), place.z());
  camera->SetPosition(eye.x(), eye.y(), eye.z());
  moved();
}

void
CloudView::showAll()
{
  const Box& box = model_.scene().bounds;
  vtkCamera* camera = actors_->renderer->GetActiveCamera();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(0, -1, 0);
  camera->SetViewUp(0, 0, 1);
  const Point size = box.high - box.low;
  lookAt((box.low + box.high) / 2, std::max(0.33 * size.norm(), 1e-3));
  look(size.x() >= size.y() ? 20 : 290, 30); // what is long lies across
}

QPointF
CloudView::pixelOf(const Point& p) const
{
  actors_->renderer->SetWorldPoint(p.x(), p.y(), p.z(), 1);
  actors_->renderer->WorldToDisplay();
  const double* at = actors_->renderer->GetDisplayPoint();
  const double ratio = devicePixelRatioF();
  return {at[0] / ratio, height() - 1 - at[1] / ratio};
}

std::pair<Ray, double>
CloudView::rayAt(QPointF pixel) const
{
  const double ratio = devicePixelRatioF();
  vtkCamera* camera = actors_->renderer->GetActiveCamera();
  const auto worldAt = [&](double depth) {
    actors_->renderer->SetDisplayPoint(
        pixel.x() * ratio, (height() - 1 - pixel.y()) * ratio, depth);
    actors_->renderer->DisplayToWorld();
    const double* at = actors_->renderer->GetWorldPoint();
    return Point(at[0] / at[3], at[1] / at[3], at[2] / at[3]);
  };
  Ray ray;
  ray.origin = pointOf(camera->GetPosition());
  ray.direction = (worldAt(0.5) - ray.origin).normalized();
  ray.spread =
      reach * 2 * std::tan(camera->GetViewAngle() / 2 / 57.29577951308232) / height();
  const Box& box = model_.scene().bounds;
  const double depth = (ray.origin - (box.low + box.high) / 2).norm() +
                       (box.high - box.low).norm() + 1e-3;
  return {ray, depth};
}

void
CloudView::renderStill()
{
  still_->stop();
  setMoving(false);
}

void
CloudView::moved()
{
  actors_->renderer->ResetCameraClippingRange();
  setMoving(true);
  still_->start();
}

void
CloudView::setMoving(bool moving)
{
  // A small cloud is drawn whole all the time.
  actors_->moving =
      moving && actors_->all.indices.size() > actors_->part.indices.size();
  actors_->all.actor->SetVisibility(actors_->moving ? 0 : 1);
  actors_->part.actor->SetVisibility(actors_->moving ? 1 : 0);
  actors_->window->Render();
}

void
CloudView::mousePressEvent(QMouseEvent* event)
{
  pressed_ = last_ = event->pos();
  dragging_ = false;
}

void
CloudView::mouseMoveEvent(QMouseEvent* event)
{
  if (event->buttons() == Qt::NoButton)
    return;
  if (!dragging_ && (event->pos() - pressed_).manhattanLength() < 4)
    return;
  dragging_ = true;
  const QPoint step = event->pos() - last_;
  last_ = event->pos();
  vtkCamera* camera = actors_->renderer->GetActiveCamera();
  const bool turns = (event->buttons() & Qt::LeftButton) != 0 &&
                     (event->modifiers() & Qt::ShiftModifier) == 0;
  if (turns) {
    const Point direction = pointOf(camera->GetDirectionOfProjection());
    const double azimuth = std::atan2(direction.x(), direction.y()) * 57.29577951308232;
    const double elevation =
        -std::asin(std::clamp(direction.z(), -1.0, 1.0)) * 57.29577951308232;
    return look(azimuth + 0.35 * step.x(), elevation + 0.35 * step.y());
  }
  const double world = 2 * camera->GetDistance() *
                       std::tan(camera->GetViewAngle() / 2 / 57.29577951308232) /
                       std::max(height(), 1);
  const Point up = pointOf(camera->GetViewUp()),
              direction = pointOf(camera->GetDirectionOfProjection());
  const Point right = direction.cross(up).normalized(),
              above = right.cross(direction).normalized();
  const Point shift = world * (-step.x() * right + step.y() * above);
  const Point eye = pointOf(camera->GetPosition()) + shift,
              focus = pointOf(camera->GetFocalPoint()) + shift;
  camera->SetPosition(eye.x(), eye.y(), eye.z());
  camera->SetFocalPoint(focus.x(), focus.y(), focus.z());
  moved();
}

void
CloudView::mouseReleaseEvent(QMouseEvent* event)
{
  if (!dragging_ && event->button() == Qt::LeftButton && on_click) {
    const auto [ray, depth] = rayAt(event->localPos());
    on_click(ray, depth);
  }
  dragging_ = false;
}

void
CloudView::mouseDoubleClickEvent(QMouseEvent*)
{
  if (const auto selected = model_.selected()) {
    vtkCamera* camera = actors_->renderer->GetActiveCamera();
    const Point& at = model_.scene().cloud.points[*selected];
    camera->SetFocalPoint(at.x(), at.y(), at.z());
    moved();
  }
}

void
CloudView::wheelEvent(QWheelEvent* event)
{
  vtkCamera* camera = actors_->renderer->GetActiveCamera();
  camera->Dolly(std::pow(1.15, event->angleDelta().y() / 120.0));
  moved();
}

} // namespace linelet::view
