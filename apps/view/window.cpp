// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "window.h"

#include <algorithm>
#include <stdexcept>

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QImage>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStatusBar>
#include <QTabWidget>
#include <QThread>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>

#include <linelet/io/output_file.h>

#include "cloud_view.h"
#include "controls.h"
#include "panels.h"
#include "wires_panel.h"

namespace linelet::view {

namespace {

QString
text(const std::string& of)
{
  return QString::fromStdString(of);
}

} // namespace

Window::Window()
    : cloud_view_(new CloudView(model)),
      controls_(new Controls(model)),
      graphs_(new GraphsPanel(model)),
      kernel_(new KernelPanel(model)),
      image_(new ImagePanel(model)),
      profile_(new ProfilePanel(model)),
      error_(new ErrorPanel(model)),
      wires_(new WiresPanel(model)),
      legend_(new LegendPanel),
      panels_(new QTabWidget),
      colors_(new QComboBox),
      size_(new QSpinBox),
      status_(new QLabel),
      progress_(new QProgressBar),
      cancel_(new QPushButton("Cancel")),
      timer_(new QTimer(this))
{
  setWindowTitle("linelet-view");
  setCentralWidget(cloud_view_);
  makeToolBar();
  makeDocks();
  statusBar()->addWidget(status_, 1);
  progress_->setMaximumWidth(320);
  statusBar()->addPermanentWidget(progress_);
  statusBar()->addPermanentWidget(cancel_);
  cancel_->setObjectName("cancel");
  progress_->hide();
  cancel_->hide();
  connect(cancel_, &QPushButton::clicked, [this] { model.cancel(); });
  cloud_view_->on_click = [this](const Ray& ray, double depth) { clicked(ray, depth); };
  connect(timer_, &QTimer::timeout, [this] { poll(); });
  timer_->start(30);
  say("Open a point cloud, curves, or a folder of powerlines.");
  resize(1500, 950);
}

Window::~Window()
{
  // The panels speak of the model, which goes first.
  timer_->stop();
  delete takeCentralWidget();
  for (QDockWidget* dock : findChildren<QDockWidget*>())
    delete dock;
}

void
Window::makeToolBar()
{
  auto* bar = addToolBar("tools");
  bar->setMovable(false);
  const auto add =
      [&](const char* label, const char* name, const char* tip, auto what) {
        QAction* action = bar->addAction(label, what);
        action->setObjectName(name);
        action->setToolTip(tip);
        return action;
      };
  add("Open…", "open", "Point files, curves", [this] {
    std::vector<std::string> paths;
    for (const QString& path : QFileDialog::getOpenFileNames(this, "Open"))
      paths.push_back(path.toStdString());
    if (!paths.empty())
      open(paths);
  });
  add("Open folder…", "open_folder", "Results of powerlines, or tiles", [this] {
    const QString path = QFileDialog::getExistingDirectory(this, "Open folder");
    if (!path.isEmpty())
      open({path.toStdString()});
  });
  bar->addSeparator();
  add("Whole cloud", "show_all", "Look at everything", [this] {
    cloud_view_->showAll();
  });
  add("From above", "from_above", "Look down", [this] { cloud_view_->look(0, 89.9); });
  add("From the side", "from_side", "Look north", [this] { cloud_view_->look(0, 5); });
  add("To the selection",
      "to_selection",
      "Look at the selected point from near",
      [this] {
        if (const auto point = model.selected())
          cloud_view_->lookAt(
              model.scene().cloud.points[*point],
              std::max(20 * model.scene().scale_unit, 3 * model.tensorRadius()));
      });
  bar->addSeparator();
  add("Preview box", "preview", "Compute in a box around the selection", [this] {
    previewAround(50 * model.scene().scale_unit);
  });
  add("No box", "no_preview", "Compute on the whole cloud", [this] {
    preview(std::nullopt);
  });
  auto* at_once = add("Recompute at once",
                      "at_once",
                      "Compute again whenever an option changes",
                      [] {});
  at_once->setCheckable(true);
  connect(at_once, &QAction::toggled, [this](bool on) { at_once_ = on; });
  bar->addSeparator();
  add("Image along the curve", "image_curve", "Multi-scale image", [this] {
    imageAlongCurve();
  });
  add("Draw a line",
      "draw_line",
      "Click its vertices; click here again to end it",
      [this] { drawing_ ? endLine() : beginLine(); });
  add("Image around the point",
      "image_point",
      "Neighborhood, along its direction",
      [this] { imageAround(); });
  auto* everywhere = add("Ellipsoids",
                         "ellipsoids",
                         "Ellipsoids of the computed tensors everywhere",
                         [] {});
  everywhere->setCheckable(true);
  connect(everywhere, &QAction::toggled, [this](bool on) {
    if (on && model.results().tensors == nullptr)
      say("Compute tensor first: its ellipsoids are shown.", true);
    cloud_view_->showEllipsoids(on);
  });
}

void
Window::makeDocks()
{
  const auto dock = [&](const char* title, QWidget* widget, Qt::DockWidgetArea area) {
    auto* box = new QDockWidget(title);
    box->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
    box->setWidget(widget);
    addDockWidget(area, box);
    return box;
  };
  colors_->setObjectName("color");
  size_->setRange(1, 12);
  size_->setValue(2);
  size_->setObjectName("point_size");
  auto* look = new QWidget;
  auto* layout = new QVBoxLayout(look);
  layout->setContentsMargins(6, 4, 6, 4);
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel("color"));
  row->addWidget(colors_, 1);
  row->addWidget(new QLabel("size"));
  row->addWidget(size_);
  layout->addLayout(row);
  layout->addWidget(legend_);
  layout->addWidget(controls_, 1);
  auto* left = dock("Cloud and options", look, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  const auto add = [&](QWidget* panel, const char* title, const char* name) {
    panel->setObjectName(name);
    panels_->addTab(panel, title);
  };
  add(graphs_, "Graphs", "graphs");
  add(kernel_, "Kernel", "kernel_panel");
  add(image_, "Multi-scale image", "image");
  add(profile_, "Span profile", "profile");
  add(error_, "Error", "error");
  add(wires_, "Wires", "wires_panel");
  auto* below = dock("Views", panels_, Qt::BottomDockWidgetArea);
  resizeDocks({left}, {340}, Qt::Horizontal);
  resizeDocks({below}, {320}, Qt::Vertical);

  connect(colors_, QOverload<int>::of(&QComboBox::activated), [this] {
    setColor(colors_->currentText().toStdString());
  });
  connect(size_, QOverload<int>::of(&QSpinBox::valueChanged), [this](int pixels) {
    cloud_view_->setPointSize(pixels);
  });
  controls_->on_compute = [this](Analysis analysis) { compute(analysis); };
  controls_->on_change = [this](Analysis analysis) {
    kernel_->refresh();
    if (analysis == Analysis::MultiScale && model.selected())
      model.select(model.selected());
    cloud_view_->showSelection();
    if (at_once_ && model.stale(analysis))
      compute(analysis);
  };
  kernel_->on_change = [this](Analysis analysis) {
    controls_->refresh();
    controls_->on_change(analysis);
  };
  controls_->on_copy = [this](Analysis analysis) {
    const std::string line = model.commandLine(analysis);
    QApplication::clipboard()->setText(text(line));
    say("Copied: " + line);
  };
  controls_->on_save = [this](Analysis analysis) {
    const QString path = QFileDialog::getSaveFileName(this, "Save options");
    if (path.isEmpty())
      return;
    try {
      io::OutputFile file(path.toStdString());
      file.write(model.config(analysis));
      file.commit();
      say("Saved; run it with linelet " + std::string(nameOf(analysis)) + " --config " +
          path.toStdString());
    }
    catch (const std::exception& error) {
      say(error.what(), true);
    }
  };
  controls_->on_load = [this](Analysis analysis) {
    const QString path = QFileDialog::getOpenFileName(this, "Load options");
    if (path.isEmpty())
      return;
    try {
      model.settings.loadConfig(analysis, path.toStdString());
      controls_->refresh();
      controls_->on_change(analysis);
    }
    catch (const std::exception& error) {
      say(error.what(), true);
    }
  };
  wires_->on_select = [this](int id) { selectWire(id); };
  wires_->on_error = [this](const std::string& error) { say(error, true); };
}

void
Window::say(const std::string& sentence, bool wrong)
{
  status_->setText(text(sentence));
  status_->setStyleSheet(wrong ? "color:#c8102e;font-weight:600" : "");
  status_->setToolTip(text(sentence));
  if (wrong)
    last_error_ = sentence;
}

void
Window::open(const std::vector<std::string>& paths, const std::string& truth)
{
  model.open(paths, truth);
  say("opening " + paths.front() + (paths.size() > 1 ? " and others" : ""));
}

void
Window::compute(Analysis analysis)
{
  try {
    model.compute(analysis);
    last_computed_ = analysis;
    say("computing " + std::string(nameOf(analysis)));
  }
  catch (const std::exception& error) {
    say(error.what(), true);
  }
}

std::string
Window::settle()
{
  last_error_.clear();
  bool busy = true;
  while (busy) {
    busy = model.busy();
    poll();
    QApplication::processEvents(QEventLoop::AllEvents, 20);
    if (busy)
      QThread::msleep(5);
  }
  return last_error_;
}

void
Window::poll()
{
  const Model::Changes changes = model.poll();
  changed(changes);
  const bool busy = model.busy();
  const Progress progress = model.progress();
  const bool long_work = busy && !progress.stage.empty();
  progress_->setVisible(long_work);
  cancel_->setVisible(long_work);
  if (long_work) {
    progress_->setRange(0, progress.part > 0 ? 1000 : 0);
    progress_->setValue(static_cast<int>(1000 * progress.part));
    progress_->setFormat(text(progress.stage + " %p %"));
  }
}

void
Window::changed(const Model::Changes& changes)
{
  if (!changes.error.empty())
    say(changes.error, true);
  if (changes.scene) {
    const Scene& scene = model.scene();
    cloud_view_->showScene();
    wires_->fill();
    fillColors(model.lines() != nullptr ? "powerlines.class" : "height");
    if (changes.error.empty())
      say(std::to_string(scene.cloud.points.size()) + " points" +
          (scene.curves.curves.empty()
               ? ""
               : ", " + std::to_string(scene.curves.curves.size()) + " curves") +
          (scene.warnings.empty() ? "" : "; " + scene.warnings.front()));
    if (model.lines() != nullptr)
      showPanel("wires");
  }
  if (changes.results) {
    static constexpr const char* colors[] = {
        "tensor.shape", "multiscale.shape", "", "powerlines.class"};
    const std::string color =
        last_computed_ ? colors[static_cast<std::size_t>(*last_computed_)] : "";
    fillColors(color.empty() ? colors_->currentText().toStdString() : color);
    wires_->fill();
    if (last_computed_ == Analysis::PowerLines)
      showPanel("wires");
    cloud_view_->showLines();
    say(std::string(last_computed_ ? nameOf(*last_computed_) : "") + ": done; " +
        std::to_string(model.curves().curves.size()) + " curves, " +
        std::to_string(model.lines() == nullptr ? 0 : model.lines()->wires.size()) +
        " wires");
  }
  if (changes.scene || changes.results) {
    controls_->refresh();
    image_->refresh();
  }
  if (changes.scene || changes.results || changes.probe) {
    graphs_->refresh();
    kernel_->refresh();
    profile_->refresh();
    error_->refresh();
    wires_->refresh();
    cloud_view_->showSelection();
  }
  if (changes.image)
    image_->refresh();
}

void
Window::fillColors(const std::string& wanted)
{
  const QSignalBlocker silent(colors_);
  colors_->clear();
  for (const std::string& field : model.fields())
    colors_->addItem(text(field));
  if (colors_->count() == 0)
    return legend_->show({});
  setColor(colors_->findText(text(wanted)) >= 0 ? wanted
                                                : colors_->itemText(0).toStdString());
}

void
Window::setColor(const std::string& field)
{
  const Coloring coloring = model.coloring(field);
  const QSignalBlocker silent(colors_);
  colors_->setCurrentIndex(colors_->findText(text(field)));
  cloud_view_->setColoring(coloring);
  legend_->show(coloring.legend);
}

void
Window::setPointSize(int pixels)
{
  size_->setValue(pixels);
}

void
Window::select(std::optional<Index> point)
{
  model.select(point);
  if (!point)
    return;
  const Point at = model.scene().cloud.points[*point] + model.scene().cloud.shift;
  say("point " + std::to_string(*point) + " at " +
      QString("%1 %2 %3")
          .arg(at.x(), 0, 'f', 2)
          .arg(at.y(), 0, 'f', 2)
          .arg(at.z(), 0, 'f', 2)
          .toStdString());
  const auto* network = model.lines();
  if (network != nullptr && *point < network->wire_id.size() &&
      network->wire_id[*point] > 0)
    selectWire(network->wire_id[*point], false);
}

void
Window::selectWire(int id, bool approach)
{
  if (id == model.wire())
    return;
  model.selectWire(id);
  const powerline::Wire& wire = model.lines()->wires[static_cast<std::size_t>(id) - 1];
  if (approach)
    cloud_view_->lookAt(model.toCloud((wire.front + wire.back) / 2),
                        std::max(0.6 * wire.span_length, 5.0));
  cloud_view_->showLines();
}

void
Window::selectCurve(int place)
{
  if (place < -1 || place >= static_cast<int>(model.curves().curves.size()))
    throw std::invalid_argument("there is no curve " + std::to_string(place) +
                                "; there are " +
                                std::to_string(model.curves().curves.size()));
  model.curve = place;
  cloud_view_->showLines();
  error_->refresh();
}

void
Window::previewAround(double half_width)
{
  if (!model.selected())
    return say("Click a point first: the box is laid around it.", true);
  const Point at = model.scene().cloud.points[*model.selected()];
  const Point half = Point::Constant(half_width);
  preview(Box{at - half, at + half});
}

void
Window::preview(const std::optional<Box>& box)
{
  model.setPreview(box);
  controls_->refresh();
  cloud_view_->showSelection();
}

void
Window::beginLine()
{
  drawing_ = true;
  cloud_view_->drawn_line.clear();
  say("Click the vertices of the line; choose Draw a line again to end it.");
}

void
Window::endLine()
{
  drawing_ = false;
  if (cloud_view_->drawn_line.size() < 2)
    return say("A line needs two vertices at least.", true);
  model.imageAlong(cloud_view_->drawn_line);
  showPanel("image");
}

void
Window::imageAlongCurve()
{
  Points line;
  const CurveNetwork& curves = model.curves();
  if (model.wire() > 0)
    for (const Point& p : powerline::polyline(
             model.lines()->wires[static_cast<std::size_t>(model.wire()) - 1]))
      line.push_back(model.toCloud(p));
  else if (model.curve >= 0)
    line = curves.curves[static_cast<std::size_t>(model.curve)].points;
  if (line.size() < 2)
    return say("Choose a wire or a curve first: the image runs along it.", true);
  model.imageAlong(line);
  showPanel("image");
}

void
Window::imageAround()
{
  try {
    model.imageAround();
    showPanel("image");
  }
  catch (const std::exception& error) {
    say(error.what(), true);
  }
}

void
Window::clicked(const Ray& ray, double depth)
{
  const Scene& scene = model.scene();
  const Index found =
      scene.grid == nullptr ? UniformGrid::none : pick(*scene.grid, ray, depth);
  if (found == UniformGrid::none)
    return say("no point there");
  if (drawing_) {
    cloud_view_->drawn_line.push_back(scene.points[found]);
    cloud_view_->showSelection();
    return;
  }
  select(found);
}

void
Window::showPanel(const std::string& name)
{
  for (int i = 0; i < panels_->count(); ++i) {
    const QString known = panels_->widget(i)->objectName();
    if (known == text(name) || known == text(name + "_panel"))
      return panels_->setCurrentIndex(i);
  }
  throw std::invalid_argument(
      "there is no panel '" + name +
      "'; there are graphs, kernel, image, profile, error, wires");
}

void
Window::shoot(const std::string& path)
{
  settle();
  cloud_view_->renderStill();
  QApplication::processEvents();
  if (!grab().save(text(path), "PNG"))
    throw std::runtime_error(path + ": cannot be written; name another file");
}

nlohmann::ordered_json
Window::state() const
{
  nlohmann::ordered_json state = model.state();
  const QPoint corner = cloud_view_->mapTo(const_cast<Window*>(this), QPoint(0, 0));
  state["view"] = {corner.x(), corner.y(), cloud_view_->width(), cloud_view_->height()};
  state["color"] = colors_->currentText().toStdString();
  state["panel"] = panels_->currentWidget()->objectName().toStdString();
  state["message"] = status_->text().toStdString();
  return state;
}

} // namespace linelet::view
