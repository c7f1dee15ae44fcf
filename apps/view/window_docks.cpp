// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QFileDialog>
#include <QLabel>
#include <QSpinBox>
#include <QTabWidget>
#include <QVBoxLayout>

#include <linelet/io/output_file.h>

#include "cloud/cloud_view.h"
#include "controls.h"
#include "panels/error_panel.h"
#include "panels/graphs_panel.h"
#include "panels/image_panel.h"
#include "panels/kernel_panel.h"
#include "panels/legend_panel.h"
#include "panels/profile_panel.h"
#include "panels/wires_panel.h"
#include "window.h"

namespace linelet::view {

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
}

void
Window::connectPanels()
{
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
    QApplication::clipboard()->setText(QString::fromStdString(line));
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

} // namespace linelet::view
