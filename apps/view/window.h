// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <string>
#include <vector>

#include <QMainWindow>

#include "model/model.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QTabWidget;
class QTimer;

namespace linelet::view {

class CloudView;
class Controls;
class ErrorPanel;
class GraphsPanel;
class ImagePanel;
class KernelPanel;
class LegendPanel;
class ProfilePanel;
class WiresPanel;

/** \brief The window: views that show one model, linked by its selection. Buttons and
 * clicks call the functions here, and so do scripts. */
class Window : public QMainWindow {
public:
  Window();
  ~Window() override;

  Model model;

  void
  open(const std::vector<std::string>& paths, const std::string& truth = {});

  /** \brief Starts computing without waiting; \ref settle waits. */
  void
  compute(Analysis analysis);

  /** \brief Waits for all running work, and shows the results.
   * \return what went wrong, in a sentence; empty: nothing */
  std::string
  settle();

  void
  setColor(const std::string& field);
  void
  setPointSize(int pixels);

  /** \brief Selects a point, and the wire it belongs to. */
  void
  select(std::optional<Index> point);
  void
  selectWire(int id, bool approach = true);
  void
  selectCurve(int place);

  /** \brief Sets the preview box to that half width around the selection, or removes
   * it. */
  void
  previewAround(double half_width);
  void
  preview(const std::optional<Box>& box);

  void
  beginLine();
  void
  endLine();
  void
  imageAlongCurve();
  void
  imageAround();

  /** \brief Opens a tab below by its name: graphs, kernel, image, profile, error,
   * wires. */
  void
  showPanel(const std::string& name);

  CloudView&
  cloudView()
  {
    return *cloud_view_;
  }
  Controls&
  controls()
  {
    return *controls_;
  }
  WiresPanel&
  wires()
  {
    return *wires_;
  }

  /** \brief Saves the window as a PNG. \throws std::runtime_error */
  void
  shoot(const std::string& path);

  /** \brief The displayed state as numbers: that of the model and of the window. */
  nlohmann::ordered_json
  state() const;

  void
  say(const std::string& sentence, bool wrong = false);

private:
  void
  poll();
  void
  changed(const Model::Changes& changes);
  void
  fillColors(const std::string& wanted);
  void
  clicked(const struct Ray& ray, double depth);
  void
  makeToolBar();
  void
  makeDocks();
  void
  connectPanels();

  CloudView* cloud_view_;
  Controls* controls_;
  GraphsPanel* graphs_;
  KernelPanel* kernel_;
  ImagePanel* image_;
  ProfilePanel* profile_;
  ErrorPanel* error_;
  WiresPanel* wires_;
  LegendPanel* legend_;
  QTabWidget* panels_;
  QComboBox* colors_;
  QSpinBox* size_;
  QLabel* status_;
  QProgressBar* progress_;
  QPushButton* cancel_;
  QTimer* timer_;
  std::string last_error_;
  std::optional<Analysis> last_computed_;
  bool drawing_ = false, at_once_ = false;
};

} // namespace linelet::view
