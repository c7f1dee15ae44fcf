// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <functional>
#include <string>

#include <QWidget>

#include "model/model.h"

class QLabel;
class QLineEdit;
class QSpinBox;
class QTableWidget;

namespace linelet::view {

/** \brief The wires, least certain first, to be accepted, rejected, reclassified or
 * annotated. */
class WiresPanel : public QWidget {
public:
  explicit WiresPanel(Model& model);

  std::function<void(int wire)> on_select;
  std::function<void(const std::string& error)> on_error;

  /** \brief Shows other wires. */
  void
  fill();

  /** \brief Shows their reviews, and which one is current. */
  void
  refresh();

  /** Actions of the buttons, on the current wire
   * @{ */
  void
  judge(powerline::Review::Verdict verdict);
  void
  setClass(int number);
  void
  setNote(const std::string& note);
  void
  step(int by); ///< go to the next wire of the table
  /** @} */

private:
  void
  say(const powerline::Review& review);
  int
  rowOf(int wire) const;

  Model& model_;
  QTableWidget* table_;
  QLabel *counts_, *reason_;
  QSpinBox* class_;
  QLineEdit* note_;
};

} // namespace linelet::view
