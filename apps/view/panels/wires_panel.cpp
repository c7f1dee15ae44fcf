// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "wires_panel.h"

#include <exception>

#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTableWidget>
#include <QVBoxLayout>

namespace linelet::view {

namespace {

using Verdict = powerline::Review::Verdict;

enum Column {
  Id,
  Span,
  Confidence,
  Length,
  Ground,
  Objects,
  Points,
  Said,
  Why,
  Columns
};

QString
text(const std::string& of)
{
  return QString::fromStdString(of);
}

QString
number(double value, int decimals)
{
  return value == value ? QString::number(value, 'f', decimals) : "–";
}

} // namespace

WiresPanel::WiresPanel(Model& model)
    : model_(model),
      table_(new QTableWidget),
      counts_(new QLabel),
      reason_(new QLabel),
      class_(new QSpinBox),
      note_(new QLineEdit)
{
  table_->setObjectName("wires");
  table_->setColumnCount(Columns);
  table_->setHorizontalHeaderLabels({"wire",
                                     "span",
                                     "confidence",
                                     "length m",
                                     "to ground m",
                                     "to objects m",
                                     "points",
                                     "said",
                                     "reason for doubt"});
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(20);
  table_->horizontalHeader()->setStretchLastSection(true);
  connect(table_, &QTableWidget::currentCellChanged, [this](int row, int, int, int) {
    if (row >= 0 && on_select)
      on_select(table_->item(row, Id)->text().toInt());
  });

  auto* bar = new QGridLayout;
  int column = 0;
  const auto add = [&](const char* label, const char* name, auto what) {
    auto* button = new QPushButton(label);
    button->setObjectName(name);
    connect(button, &QPushButton::clicked, what);
    bar->addWidget(button, 0, column++);
  };
  add("◀", "previous", [this] { step(-1); });
  add("▶", "next", [this] { step(1); });
  add("Accept", "accept", [this] { judge(Verdict::Accepted); });
  add("Reject", "reject", [this] { judge(Verdict::Rejected); });
  add("Undecided", "undecided", [this] { judge(Verdict::None); });
  class_->setRange(-1, 255);
  class_->setSpecialValueText("as wires");
  class_->setObjectName("review_class");
  class_->setKeyboardTracking(false);
  note_->setObjectName("review_note");
  bar->addWidget(new QLabel("class"), 0, column++);
  bar->addWidget(class_, 0, column++);
  bar->addWidget(new QLabel("note"), 0, column++);
  bar->addWidget(note_, 0, column);
  bar->setColumnStretch(column, 1);
  connect(class_, QOverload<int>::of(&QSpinBox::valueChanged), [this](int number) {
    setClass(number);
  });
  connect(note_, &QLineEdit::editingFinished, [this] {
    setNote(note_->text().toStdString());
  });
  reason_->setWordWrap(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addWidget(counts_);
  layout->addWidget(table_, 1);
  layout->addWidget(reason_);
  layout->addLayout(bar);
  fill();
}

int
WiresPanel::rowOf(int wire) const
{
  for (int row = 0; row < table_->rowCount(); ++row)
    if (table_->item(row, Id)->text().toInt() == wire)
      return row;
  return -1;
}

void
WiresPanel::fill()
{
  const QSignalBlocker silent(table_);
  const std::vector<int> ids = model_.wiresByConfidence();
  table_->setRowCount(static_cast<int>(ids.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const int id = ids[static_cast<std::size_t>(row)];
    const powerline::Wire& wire =
        model_.lines()->wires[static_cast<std::size_t>(id) - 1];
    const auto put = [&](int place, const QString& what) {
      auto* item = new QTableWidgetItem(what);
      if (place < Said)
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      table_->setItem(row, place, item);
    };
    put(Id, QString::number(id));
    put(Span, QString::number(wire.span));
    put(Confidence, number(wire.confidence, 2));
    put(Length, number(wire.length, 1));
    put(Ground, number(wire.ground.distance, 1));
    put(Objects, number(wire.vegetation.distance, 1));
    put(Points, QString::number(wire.points));
    put(Said, "");
    put(Why, text(wire.reason));
  }
  for (int place = 0; place < Why; ++place)
    table_->resizeColumnToContents(place);
  table_->setColumnWidth(Said, 90);
  refresh();
}

void
WiresPanel::refresh()
{
  const QSignalBlocker silent(table_), silent_class(class_), silent_note(note_);
  std::size_t accepted = 0, rejected = 0;
  for (int row = 0; row < table_->rowCount(); ++row) {
    const powerline::Review& said =
        model_.review(table_->item(row, Id)->text().toInt());
    accepted += said.verdict == Verdict::Accepted ? 1 : 0;
    rejected += said.verdict == Verdict::Rejected ? 1 : 0;
    QString words = text(std::string(nameOf(said.verdict)));
    if (said.point_class >= 0)
      words += QString(" class %1").arg(said.point_class);
    if (!said.note.empty())
      words += " ✎";
    table_->item(row, Said)->setText(words.trimmed());
  }
  counts_->setText(
      model_.lines() == nullptr
          ? QString("no wires yet: compute powerlines, or open a folder of its results")
          : QString(
                "%1 wires, the least certain first; %2 accepted, %3 rejected; saved "
                "as %4")
                .arg(table_->rowCount())
                .arg(accepted)
                .arg(rejected)
                .arg(text(model_.reviewFile())));
  const int id = model_.wire(), row = rowOf(id);
  if (row >= 0 && row != table_->currentRow())
    table_->setCurrentCell(row, 0);
  reason_->setVisible(id > 0);
  if (id == 0)
    return;
  const powerline::Wire& wire = model_.lines()->wires[static_cast<std::size_t>(id) - 1];
  const powerline::Review& said = model_.review(id);
  reason_->setText(
      QString("wire %1: %2")
          .arg(id)
          .arg(wire.reason.empty() ? QString("no doubts") : text(wire.reason)));
  class_->setValue(said.point_class);
  note_->setText(text(said.note));
}

void
WiresPanel::say(const powerline::Review& review)
{
  try {
    model_.setReview(model_.wire(), review);
  }
  catch (const std::exception& error) {
    if (on_error)
      on_error(error.what());
  }
  refresh();
}

void
WiresPanel::judge(Verdict verdict)
{
  powerline::Review review;
  if (model_.wire() > 0)
    review = model_.review(model_.wire());
  review.verdict = verdict;
  say(review);
}

void
WiresPanel::setClass(int number)
{
  if (model_.wire() == 0)
    return;
  powerline::Review review = model_.review(model_.wire());
  review.point_class = number;
  say(review);
}

void
WiresPanel::setNote(const std::string& note)
{
  if (model_.wire() == 0 || model_.review(model_.wire()).note == note)
    return;
  powerline::Review review = model_.review(model_.wire());
  review.note = note;
  say(review);
}

void
WiresPanel::step(int by)
{
  const int row = rowOf(model_.wire());
  const int next = row < 0 ? 0 : row + by;
  if (next >= 0 && next < table_->rowCount())
    table_->setCurrentCell(next, 0);
}

} // namespace linelet::view
