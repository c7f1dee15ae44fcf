// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "controls.h"

#include <stdexcept>

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QTabWidget>
#include <QVBoxLayout>

namespace linelet::view {

namespace {

QString
text(std::string_view of)
{
  return QString::fromUtf8(of.data(), static_cast<int>(of.size()));
}

/** \brief Writes \a value into an editor without emitting a signal. */
void
write(QWidget* editor, const std::string& value)
{
  const QSignalBlocker silent(editor);
  if (auto* box = qobject_cast<QCheckBox*>(editor))
    box->setChecked(value == "true");
  else if (auto* combo = qobject_cast<QComboBox*>(editor)) {
    const int place = combo->findText(text(value));
    if (place >= 0)
      combo->setCurrentIndex(place);
    else
      combo->setEditText(text(value));
  }
  else if (auto* line = qobject_cast<QLineEdit*>(editor))
    line->setText(text(value));
}

} // namespace

Controls::Controls(Model& model) : model_(model), tabs_(new QTabWidget)
{
  for (const auto& [analysis, name] : Names<Analysis>::table)
    tabs_->addTab(makePage(analysis), text(name));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(tabs_);
  refresh();
}

QWidget*
Controls::makeEditor(Analysis analysis, const Parameter& p)
{
  const std::string name = p.name;
  QWidget* editor = nullptr;
  if (p.kind == Parameter::Kind::Flag) {
    auto* box = new QCheckBox;
    connect(box, &QCheckBox::toggled, [=](bool on) {
      apply(analysis, name, on ? "true" : "false");
    });
    editor = box;
  }
  else if (p.kind == Parameter::Kind::Choice) {
    auto* combo = new QComboBox;
    for (const std::string& choice : p.choices)
      combo->addItem(text(choice));
    const auto take = [=] {
      apply(analysis, name, combo->currentText().toStdString());
    };
    if (p.range.find("one of") != 0) { // other values may be typed
      combo->setEditable(true);
      connect(combo->lineEdit(), &QLineEdit::editingFinished, take);
    }
    combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(combo, QOverload<int>::of(&QComboBox::activated), take);
    editor = combo;
  }
  else {
    auto* line = new QLineEdit;
    connect(line, &QLineEdit::editingFinished, [=] {
      apply(analysis, name, line->text().toStdString());
    });
    editor = line;
  }
  editor->setObjectName(text(std::string(nameOf(analysis)) + "." + name));
  editor->setToolTip(text("--" + name + ": " + p.meaning +
                          "\nrange: " + (p.range.empty() ? "text" : p.range) +
                          (p.unit.empty() ? "" : "\nunit: " + p.unit) +
                          "\ndefault: " + (p.standard.empty() ? "none" : p.standard)));
  return editor;
}

QWidget*
Controls::makePage(Analysis analysis)
{
  Page& page = pages_[static_cast<std::size_t>(analysis)];
  auto* form = new QWidget;
  auto* rows = new QVBoxLayout(form);
  std::map<std::string, QFormLayout*> groups;
  for (const Parameter& p : model_.settings.parameters(analysis)) {
    QFormLayout*& group = groups[p.heading];
    if (group == nullptr) {
      auto* box = new QGroupBox(text(p.heading.empty() ? "options" : p.heading));
      group = new QFormLayout(box);
      group->setRowWrapPolicy(QFormLayout::WrapLongRows);
      rows->addWidget(box);
    }
    QWidget* editor = makeEditor(analysis, p);
    page.editors[p.name] = editor;
    group->addRow(text(p.name + (p.unit.empty() ? "" : " [" + p.unit + "]")), editor);
    const std::string range = p.range.empty() ? "" : " (" + p.range + ")";
    auto* meaning = new QLabel(text(p.meaning + range));
    meaning->setWordWrap(true);
    meaning->setStyleSheet("color:#5d6873;font-size:10px");
    group->addRow(meaning);
  }
  rows->addStretch(1);
  auto* scroll = new QScrollArea;
  scroll->setWidget(form);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);

  auto* buttons = new QGridLayout;
  const auto add = [&](const char* label,
                       const char* name,
                       std::function<void(Analysis)> Controls::*what,
                       int place) {
    auto* button = new QPushButton(label);
    button->setObjectName(text(std::string(nameOf(analysis)) + "." + name));
    connect(button, &QPushButton::clicked, [=] {
      if (this->*what)
        (this->*what)(analysis);
    });
    buttons->addWidget(button, place / 2, place % 2);
  };
  add("Compute", "compute", &Controls::on_compute, 0);
  add("Copy the command", "copy", &Controls::on_copy, 1);
  add("Load options…", "load", &Controls::on_load, 2);
  add("Save options…", "save", &Controls::on_save, 3);
  page.state = new QLabel;
  page.message = new QLabel;
  page.message->setWordWrap(true);
  page.message->setStyleSheet("color:#c8102e");
  auto* whole = new QWidget;
  auto* layout = new QVBoxLayout(whole);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->addWidget(scroll, 1);
  layout->addWidget(page.message);
  layout->addWidget(page.state);
  layout->addLayout(buttons);
  return whole;
}

void
Controls::apply(Analysis analysis, const std::string& name, const std::string& value)
{
  try {
    edit(analysis, name, value);
  }
  catch (const std::invalid_argument&) {
    // The model shows the error.
  }
}

void
Controls::edit(Analysis analysis, const std::string& name, const std::string& value)
{
  QLabel* message = pages_[static_cast<std::size_t>(analysis)].message;
  for (const Parameter& p : model_.settings.parameters(analysis))
    if (p.name == name && p.value == value)
      return message->clear();
  try {
    model_.settings.set(analysis, name, value);
    message->clear();
  }
  catch (const std::invalid_argument& error) {
    message->setText(text(error.what()));
    throw;
  }
  refresh();
  if (on_change)
    on_change(analysis);
}

void
Controls::refresh()
{
  for (const auto& [analysis, name] : Names<Analysis>::table) {
    Page& page = pages_[static_cast<std::size_t>(analysis)];
    for (const Parameter& p : model_.settings.parameters(analysis))
      write(page.editors.at(p.name), p.value);
    page.state->setText(
        model_.stale(analysis)
            ? "<span style='color:#8a5a00'>shown: other options than these</span>"
            : "");
  }
}

Analysis
Controls::current() const
{
  return static_cast<Analysis>(tabs_->currentIndex());
}

void
Controls::open(Analysis analysis)
{
  tabs_->setCurrentIndex(static_cast<int>(analysis));
}

} // namespace linelet::view
