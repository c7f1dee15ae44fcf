// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "kernel_panel.h"

#include <algorithm>
#include <array>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "model/profiles.h"
#include "panel_colors.h"

namespace linelet::view {

KernelPanel::KernelPanel(Model& model)
    : model_(model), plot_(new Plot), of_(new QComboBox), kernel_(new QComboBox)
{
  of_->addItems({"tensor", "multiscale"});
  of_->setObjectName("kernel_of");
  kernel_->setObjectName("kernel");
  for (const auto& [kernel, name] : Names<Kernel>::table)
    if (kernel != Kernel::FermiDirac && kernel != Kernel::Step)
      kernel_->addItem(QString::fromUtf8(name.data(), static_cast<int>(name.size())));
  kernel_->addItems({"fermi-dirac:0.5,0.1", "step:0.5"});
  auto* bar = new QHBoxLayout;
  bar->addWidget(new QLabel("weights of"));
  bar->addWidget(of_);
  bar->addWidget(new QLabel("kernel"));
  bar->addWidget(kernel_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2, 4, 2, 2);
  layout->addLayout(bar);
  layout->addWidget(plot_, 1);
  plot_->x_title = "distance / radius";
  plot_->y_title = "weight";
  connect(of_, QOverload<int>::of(&QComboBox::activated), [this] { refresh(); });
  connect(kernel_, QOverload<int>::of(&QComboBox::activated), [this] {
    setWeight(kernel_->currentText().toStdString());
  });
}

void
KernelPanel::setWeight(const std::string& text)
{
  const Analysis analysis =
      of_->currentIndex() == 0 ? Analysis::Tensor : Analysis::MultiScale;
  model_.settings.set(analysis, "weight", text);
  refresh();
  if (on_change)
    on_change(analysis);
}

void
KernelPanel::refresh()
{
  const bool tensor = of_->currentIndex() == 0;
  const Weighting& weight =
      tensor ? model_.settings.tensor.weighting : model_.settings.scales.weighting;
  plot_->clear();
  const int place = kernel_->findText(QString::fromStdString(weight.name()));
  kernel_->setCurrentIndex(place);
  Plot::Line line;
  line.name = QString::fromStdString(weight.name());
  line.color = dark;
  line.width = 2.5;
  double highest = 1;
  for (int i = 0; i <= 300; ++i) {
    const double x = i / 250.0, w = weight(x);
    line.points.emplace_back(x, w);
    highest = std::max(highest, w);
  }
  const double radius =
      tensor ? model_.tensorRadius()
             : (model_.graphs() == nullptr ? 0 : model_.graphs()->ownRadius());
  plot_->title = "click a point for the distances of its neighbors";
  if (model_.selected() && radius > 0) {
    const auto counts =
        distanceHistogram(model_.scene(), *model_.selected(), radius, 40);
    const std::size_t most = *std::max_element(counts.begin(), counts.end());
    std::size_t all = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      all += counts[i];
      if (most > 0)
        plot_->bars.push_back(
            {static_cast<double>(i) / 40,
             static_cast<double>(i + 1) / 40,
             static_cast<double>(counts[i]) / static_cast<double>(most)});
    }
    plot_->title =
        QString("%1 neighbors within %2 (bars: histogram of their distances)")
            .arg(all)
            .arg(radius, 0, 'g', 4);
  }
  plot_->lines.push_back(std::move(line));
  const std::array<double, 2> parameters = weight.parameters();
  const bool fermi =
      weight.kernel() == Kernel::FermiDirac || weight.kernel() == Kernel::FermiDirac1 ||
      weight.kernel() == Kernel::FermiDirac2 || weight.kernel() == Kernel::FermiDirac3;
  const auto text = [](const char* name, double a) {
    return QString("%1%2").arg(name).arg(a, 0, 'g', 4).toStdString();
  };
  if (fermi) {
    const double m = parameters[0], t = parameters[1];
    const auto set = [this, text](double to_m, double to_t) {
      setWeight(text("fermi-dirac:", std::clamp(to_m, 0.0, 1.2)) +
                text(",", std::clamp(to_t, 0.001, 1.0)));
    };
    plot_->handles.push_back(
        {{m, weight(m)}, "m", [=](QPointF to) { set(to.x(), t); }});
    plot_->handles.push_back({{m + 2 * t, weight(m + 2 * t)}, "T", [=](QPointF to) {
                                set(m, (to.x() - m) / 2);
                              }});
  }
  if (weight.kernel() == Kernel::Step)
    plot_->handles.push_back({{parameters[0], 0.5}, "S", [=](QPointF to) {
                                setWeight(text("step:", std::max(0.0, to.x())));
                              }});
  if (tensor && radius > 0)
    plot_->handles.push_back({{1, 0.02}, "radius", [=](QPointF to) {
                                model_.settings.set(
                                    Analysis::Tensor,
                                    "radius",
                                    text("", radius * std::clamp(to.x(), 0.05, 1.19)));
                                refresh();
                                if (on_change)
                                  on_change(Analysis::Tensor);
                              }});
  plot_->setRange(0, 1.2, 0, 1.05 * highest);
  plot_->update();
}

} // namespace linelet::view
