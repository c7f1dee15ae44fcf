// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "panels.h"

#include <algorithm>
#include <cmath>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

#include "model/profiles.h"
#include "picture/color.h"

namespace linelet::view {

namespace {

const QColor linear(110, 114, 120), planar(33, 84, 217), spherical(26, 158, 51),
    yellow(222, 165, 0), red(205, 30, 30), dark(40, 44, 50);

QColor
faded(QColor color, int alpha)
{
  color.setAlpha(alpha);
  return color;
}

QColor
colorOf(const apps::Color& c)
{
  return QColor::fromRgbF(c[0], c[1], c[2]);
}

QColor
colorOfWire(std::size_t i)
{
  static const QColor colors[] = {{0, 114, 178},
                                  {230, 159, 0},
                                  {0, 158, 115},
                                  {142, 94, 162},
                                  {86, 180, 233},
                                  {140, 109, 49}};
  return colors[i % 6];
}

} // namespace

GraphsPanel::GraphsPanel(const Model& model) : model_(model)
{
  x_title = "radius, unit of the file";
  y_title = "shape factor";
  log_x = true;
  empty_text =
      "Click a point of the cloud: this shows how linear, planar and spherical "
      "its neighborhood is at every radius, and which radius is its own.";
}

void
GraphsPanel::refresh()
{
  clear();
  title.clear();
  const PointGraphs* graphs = model_.graphs();
  if (graphs == nullptr)
    return update();
  const std::vector<double>& radii = graphs->radii;
  const QColor colors[] = {linear, planar, spherical};
  const char* names[] = {"linearity", "planarity", "sphericity"};
  for (std::size_t factor = 0; factor < 3; ++factor) {
    Band band;
    band.color = faded(colors[factor], 45);
    Line line;
    line.name = names[factor];
    line.color = colors[factor];
    line.width = 2;
    for (std::size_t k = 0; k < radii.size(); ++k) {
      const ScaleShape& s = graphs->graph[k];
      const float value = factor == 0   ? s.linearity
                          : factor == 1 ? s.planarity
                                        : s.sphericity;
      line.points.emplace_back(radii[k], static_cast<double>(value));
      if (k < graphs->spread.size()) {
        const auto& spread = graphs->spread[k];
        band.low.emplace_back(radii[k], spread.mean[factor] - spread.deviation[factor]);
        band.high.emplace_back(radii[k],
                               spread.mean[factor] + spread.deviation[factor]);
      }
    }
    bands.push_back(std::move(band));
    lines.push_back(std::move(line));
  }
  for (const GraphMaximum& maximum : graphs->reading.maxima) {
    const bool own = maximum.scale == graphs->scale;
    marks.push_back(
        {radii[maximum.scale],
         own ? red : dark,
         (own ? QString("own scale %1, ").arg(radii[maximum.scale], 0, 'g', 4)
              : QString()) +
             QString("score %1").arg(maximum.score, 0, 'f', 3),
         own ? 2.5 : 1.5,
         std::clamp(maximum.score / 2, 0.1, 1.0)});
  }
  title = QString("point %1: lines are its own graphs (%2), bands its neighbors' mean "
                  "± standard deviation")
              .arg(*model_.selected())
              .arg(graphs->stored ? "as computed" : "engine sweep");
  if (graphs->scale == LinearityGraph::none)
    title = QString("point %1 has no scale of its own: too few neighbors")
                .arg(*model_.selected());
  const double last = radii.size() > 1 ? radii.back() : 2 * radii.front();
  setRange(radii.front(), last, 0, 1.02);
  update();
}

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
    plot_->title = QString("%1 neighbors within %2 (bars: how many lie how far)")
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

ImagePanel::ImagePanel(const Model& model) : model_(model)
{
  setMinimumSize(220, 150);
}

void
ImagePanel::refresh()
{
  const ScaleImage* image = model_.image();
  image_ = QImage();
  if (image != nullptr && !image->columns.empty()) {
    const int w = static_cast<int>(image->columns.size()),
              h = static_cast<int>(image->radii.size());
    image_ = QImage(w, h, QImage::Format_RGB32);
    for (int x = 0; x < w; ++x)
      for (int y = 0; y < h; ++y) {
        const ScaleShape& s = image->columns[static_cast<std::size_t>(x)]
                                            [static_cast<std::size_t>(h - 1 - y)];
        const QColor color =
            std::isnan(s.linearity)
                ? QColor(255, 255, 255)
                : colorOf(apps::shapeColor(apps::ShapeColors::Safe,
                                           static_cast<double>(s.linearity),
                                           static_cast<double>(s.planarity),
                                           static_cast<double>(s.sphericity)));
        image_.setPixelColor(x, y, color);
      }
  }
  update();
}

void
ImagePanel::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.fillRect(rect(), Qt::white);
  const ScaleImage* image = model_.image();
  if (image_.isNull() || image == nullptr) {
    painter.setPen(QColor(110, 116, 124));
    painter.drawText(rect().adjusted(12, 12, -12, -12),
                     Qt::AlignCenter | Qt::TextWordWrap,
                     "Shape over radius, place by place: choose Image along the curve, "
                     "along a line that you draw, or around the selected point.");
    return;
  }
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF in(56, 14, width() - 68, height() - 56);
  painter.drawImage(in, image_);
  const auto columns = static_cast<double>(image->columns.size());
  const auto rows = static_cast<double>(image->radii.size());
  const auto x = [&](std::size_t i) {
    return in.left() + (static_cast<double>(i) + 0.5) / columns * in.width();
  };
  // The optimal scale of every place, and the area under its linearity graph.
  float most = 1e-9F;
  for (const MultiScaleShape& shape : image->shapes)
    most = std::max(most, std::isnan(shape.linearity_sum) ? 0 : shape.linearity_sum);
  QPolygonF sum;
  for (std::size_t i = 0; i < image->shapes.size(); ++i) {
    const MultiScaleShape& shape = image->shapes[i];
    if (shape.scale >= 0) {
      const double y = in.bottom() - (shape.scale + 0.5) / rows * in.height();
      painter.fillRect(QRectF(x(i) - in.width() / columns / 2,
                              y - 1.5,
                              std::max(1.0, in.width() / columns),
                              3),
                       Qt::black);
    }
    if (!std::isnan(shape.linearity_sum))
      sum << QPointF(x(i),
                     in.bottom() -
                         static_cast<double>(shape.linearity_sum / most) * in.height());
  }
  painter.setPen(QPen(spherical, 1.5));
  painter.drawPolyline(sum);
  painter.setPen(dark);
  painter.drawRect(in);
  const int step =
      std::max(1, static_cast<int>(18 * rows / std::max(in.height(), 1.0)) + 1);
  for (std::size_t k = 0; k < image->radii.size(); k += static_cast<std::size_t>(step))
    painter.drawText(
        QRectF(0,
               in.bottom() - (static_cast<double>(k) + 0.5) / rows * in.height() - 8,
               52,
               16),
        Qt::AlignRight | Qt::AlignVCenter,
        QString::number(image->radii[k], 'g', 3));
  for (const double part : {0.0, 0.5, 1.0}) {
    const auto i = static_cast<std::size_t>(part * (columns - 1));
    painter.drawText(QRectF(x(i) - 50, in.bottom() + 2, 100, 16),
                     Qt::AlignCenter,
                     QString::number(image->along[i], 'g', 4));
  }
  painter.drawText(QRectF(in.left(), in.bottom() + 18, in.width(), 18),
                   Qt::AlignCenter,
                   "place along the line (black: own scale; green: area under the "
                   "linearity graph); upwards: radius");
}

ProfilePanel::ProfilePanel(const Model& model) : model_(model)
{
  x_title = "meters along the span";
  y_title = "height, m";
  empty_text = "Choose a wire in the table, or click one of its points: this shows its "
               "span from the side.";
}

void
ProfilePanel::refresh()
{
  clear();
  title.clear();
  const auto* network = model_.lines();
  if (network == nullptr || model_.wire() == 0)
    return update();
  const powerline::Wire& chosen =
      network->wires[static_cast<std::size_t>(model_.wire()) - 1];
  const SpanProfile profile = profileOf(model_.scene(), *network, chosen.span);
  const auto toLine = [](const std::vector<SpanProfile::Place>& places) {
    std::vector<QPointF> points;
    for (const auto& p : places)
      points.emplace_back(p.along, p.height);
    return points;
  };
  Line others, ground;
  others.color = QColor(168, 178, 166);
  others.width = 2;
  others.dots = true;
  others.points = toLine(profile.others);
  lines.push_back(others);
  ground.color = QColor(140, 112, 70);
  ground.points = toLine(profile.ground);
  lines.push_back(ground);
  for (std::size_t i = 0; i < profile.wires.size(); ++i) {
    const SpanProfile::Wire& wire = profile.wires[i];
    const bool is_chosen = wire.id == model_.wire();
    Line points, curve;
    points.color = faded(colorOfWire(i), is_chosen ? 255 : 130);
    points.width = is_chosen ? 4 : 2.5;
    points.dots = true;
    points.points = toLine(wire.points);
    if (is_chosen)
      curve.name = QString("wire %1").arg(wire.id);
    curve.color = is_chosen ? QColor(230, 20, 140) : colorOfWire(i);
    curve.width = is_chosen ? 2.5 : 1.2;
    curve.points = toLine(wire.curve);
    lines.push_back(std::move(points));
    lines.push_back(std::move(curve));
  }
  for (const SpanProfile::Measure& measure : profile.clearances) {
    if (measure.wire != model_.wire())
      continue;
    Line line;
    line.name = QString("%1 m to %2")
                    .arg(measure.distance, 0, 'f', 2)
                    .arg(measure.to_ground ? "ground" : "objects");
    line.color = measure.distance < model_.settings.wires.clearance ? red : dark;
    line.style = Qt::DashLine;
    line.points = {{measure.from.along, measure.from.height},
                   {measure.to.along, measure.to.height}};
    lines.push_back(std::move(line));
  }
  title = QString("span %1: %2 m, wire %3, confidence %4")
              .arg(profile.span)
              .arg(profile.length, 0, 'f', 1)
              .arg(chosen.id)
              .arg(chosen.confidence, 0, 'f', 2);
  fitRange();
  update();
}

ErrorPanel::ErrorPanel(const Model& model) : model_(model)
{
  x_title = "along the curve, unit of the file";
  y_title = "distance (unit) and angle (90° = full height)";
  empty_text = "Open true curves with --truth FILE, and choose a curve: this shows how "
               "far it is from them, and how far turned.";
}

void
ErrorPanel::refresh()
{
  clear();
  title.clear();
  const CurveNetwork& curves = model_.curves();
  const CurveNetwork& truth = model_.scene().truth;
  const auto chosen = static_cast<std::size_t>(model_.curve);
  if (truth.curves.empty() || model_.curve < 0 || chosen >= curves.curves.size())
    return update();
  const std::vector<VertexError> errors = errorsAlong(curves.curves[chosen], truth);
  double most = 0, sum = 0;
  for (const VertexError& e : errors) {
    most = std::max(most, e.distance);
    sum += e.distance;
  }
  Line distance, angle;
  distance.name = "distance";
  distance.color = yellow;
  distance.width = 2;
  angle.name = QString("angle, %1 = 90°").arg(most, 0, 'g', 3);
  angle.color = spherical;
  for (const VertexError& e : errors) {
    distance.points.emplace_back(e.along, e.distance);
    angle.points.emplace_back(e.along, e.angle / 90 * (most > 0 ? most : 1));
  }
  title = QString("curve %1 of %2: mean distance %3, largest %4")
              .arg(chosen + 1)
              .arg(curves.curves.size())
              .arg(sum / static_cast<double>(std::max<std::size_t>(errors.size(), 1)),
                   0,
                   'g',
                   3)
              .arg(most, 0, 'g', 3);
  lines.push_back(std::move(distance));
  lines.push_back(std::move(angle));
  fitRange();
  update();
}

LegendPanel::LegendPanel(QWidget* parent) : QWidget(parent)
{
  setMinimumHeight(90);
}

void
LegendPanel::show(const Legend& legend)
{
  legend_ = legend;
  const int rows = static_cast<int>(legend.entries.size());
  setMinimumHeight(legend.shape ? 146 : rows > 0 ? 26 + 17 * rows : 66);
  update();
}

void
LegendPanel::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(dark);
  painter.drawText(QRectF(4, 2, width() - 8, 18),
                   Qt::AlignLeft | Qt::AlignVCenter,
                   QString::fromStdString(legend_.title));
  if (legend_.scale) {
    const QRectF bar(6, 22, width() - 12, 16);
    for (int i = 0; i < static_cast<int>(bar.width()); ++i)
      painter.fillRect(QRectF(bar.left() + i, bar.top(), 1.5, bar.height()),
                       colorOf(apps::scalarColor(i / bar.width())));
    for (const double part : {0.0, 0.5, 1.0})
      painter.drawText(
          QRectF(bar.left() + part * (bar.width() - 70), 40, 70, 18),
          part == 0   ? Qt::AlignLeft
          : part == 1 ? Qt::AlignRight
                      : Qt::AlignCenter,
          QString::number(legend_.low + part * (legend_.high - legend_.low), 'g', 5));
    return;
  }
  if (legend_.shape) {
    // Barycentric: linear to the left, planar to the right, spherical above.
    const double side = std::min(110.0, width() - 120.0), rise = 0.87 * side;
    const QPointF corner(10, 24);
    for (int y = 0; y < static_cast<int>(rise); ++y)
      for (int x = 0; x < static_cast<int>(side); ++x) {
        const double s = 1 - y / rise, p = x / side - s / 2, l = 1 - s - p;
        if (p >= 0 && l >= 0)
          painter.fillRect(QRectF(corner.x() + x, corner.y() + y, 1.2, 1.2),
                           colorOf(apps::shapeColor(apps::ShapeColors::Safe, l, p, s)));
      }
    painter.drawText(QPointF(corner.x() + side / 2 + 16, corner.y() + 12), "spherical");
    painter.drawText(QPointF(corner.x() + side + 4, corner.y() + rise), "planar");
    painter.drawText(QPointF(corner.x() - 4, corner.y() + rise + 15), "linear");
    return;
  }
  for (std::size_t i = 0; i < legend_.entries.size(); ++i) {
    const double y = 22 + 17 * static_cast<double>(i);
    painter.fillRect(QRectF(6, y + 3, 12, 12), colorOf(legend_.entries[i].color));
    painter.drawText(QRectF(24, y, width() - 28, 18),
                     Qt::AlignLeft | Qt::AlignVCenter,
                     QString::fromStdString(legend_.entries[i].text));
  }
}

} // namespace linelet::view
