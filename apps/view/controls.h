// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>

#include <QWidget>

#include "model/model.h"

class QFormLayout;
class QLabel;
class QPushButton;
class QTabWidget;

namespace linelet::view {

/** \brief Controls for every option of the four analyses, generated from their
 * descriptions, and their buttons. */
class Controls : public QWidget {
public:
  explicit Controls(Model& model);

  std::function<void(Analysis)> on_change;  ///< a setting changed
  std::function<void(Analysis)> on_compute; ///< computation requested
  std::function<void(Analysis)> on_save, on_load, on_copy;

  /** \brief As if \a text had been typed into the option's field.
   * \throws std::invalid_argument with the reason, which is also shown beside the
   * field */
  void
  edit(Analysis analysis, const std::string& name, const std::string& text);

  /** \brief Shows the current settings, and which results are out of date. */
  void
  refresh();

  /** \brief The tab that is open. */
  Analysis
  current() const;
  void
  open(Analysis analysis);

private:
  struct Page {
    std::map<std::string, QWidget*> editors;
    QLabel *message = nullptr, *state = nullptr;
  };

  QWidget*
  makePage(Analysis analysis);
  QWidget*
  makeEditor(Analysis analysis, const Parameter& parameter);
  void
  apply(Analysis analysis, const std::string& name, const std::string& text);

  Model& model_;
  QTabWidget* tabs_;
  std::array<Page, 4> pages_;
};

} // namespace linelet::view
