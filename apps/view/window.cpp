// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "window.h"

#include <stdexcept>

#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStatusBar>
#include <QTabWidget>
#include <QThread>
#include <QTimer>

#include "cloud/cloud_view.h"
#include "controls.h"
#include "panels/error_panel.h"
#include "panels/graphs_panel.h"
#include "panels/image_panel.h"
#include "panels/kernel_panel.h"
#include "panels/legend_panel.h"
#include "panels/profile_panel.h"
#include "panels/wires_panel.h"

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
  connectPanels();
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
  // The panels refer to the model, a member, which would otherwise be destroyed first.
  timer_->stop();
  delete takeCentralWidget();
  for (QDockWidget* dock : findChildren<QDockWidget*>())
    delete dock;
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
