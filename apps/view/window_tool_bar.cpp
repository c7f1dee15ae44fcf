// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>

#include <QFileDialog>
#include <QToolBar>

#include "cloud/cloud_view.h"
#include "window.h"

namespace linelet::view {

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
      "Look at the selected point from close up",
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

} // namespace linelet::view
