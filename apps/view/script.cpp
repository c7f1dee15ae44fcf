// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "script.h"

#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <QApplication>
#include <QMouseEvent>

#include <linelet/io/output_file.h>

#include "cloud/cloud_view.h"
#include "controls.h"
#include "panels/wires_panel.h"
#include "window.h"

namespace linelet::view {

namespace {

using Words = std::vector<std::string>;
using Verdict = powerline::Review::Verdict;

struct Step {
  const char* meaning;
  std::size_t words; ///< arguments after its name, at least
  std::function<void(Window&, const Words&)> run;
};

double
number(const std::string& word)
{
  std::size_t read = 0;
  double value = 0;
  try {
    value = std::stod(word, &read);
  }
  catch (const std::exception&) {
    read = 0;
  }
  if (read == 0 || read != word.size())
    throw std::invalid_argument("'" + word + "' is not a number");
  return value;
}

std::string
rest(const Words& words, std::size_t from)
{
  std::string text;
  for (std::size_t i = from; i < words.size(); ++i)
    text += (i > from ? " " : "") + words[i];
  return text;
}

void
writeText(const std::string& path, const std::string& text)
{
  io::OutputFile file(path);
  file.write(text);
  file.commit();
}

/** \brief A click of the left button at a position in the view, through Qt's events. */
void
click(QWidget& widget, QPointF at)
{
  for (const auto type : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
    QMouseEvent event(type,
                      at,
                      widget.mapToGlobal(at.toPoint()),
                      Qt::LeftButton,
                      type == QEvent::MouseButtonPress ? Qt::LeftButton : Qt::NoButton,
                      Qt::NoModifier);
    QApplication::sendEvent(&widget, &event);
  }
}

const std::map<std::string, Step>&
steps()
{
  static const std::map<std::string, Step> all = {
      {"open",
       {"PATH...: open files or a folder",
        1,
        [](Window& w, const Words& a) {
          w.open({a.begin(), a.end()});
        }}},
      {"color",
       {"FIELD: color the points by it",
        1,
        [](Window& w, const Words& a) { w.setColor(a[0]); }}},
      {"size",
       {"PIXELS: of the points",
        1,
        [](Window& w, const Words& a) {
          w.setPointSize(static_cast<int>(number(a[0])));
        }}},
      {"point",
       {"N: select that point of the file",
        1,
        [](Window& w, const Words& a) {
          const double place = number(a[0]);
          if (!(place >= 0 &&
                place < static_cast<double>(w.model.scene().points.size())))
            throw std::invalid_argument("there is no point " + a[0]);
          w.select(static_cast<Index>(place));
        }}},
      {"pick",
       {"X Y Z: select the point nearest to that place",
        3,
        [](Window& w, const Words& a) {
          const Scene& scene = w.model.scene();
          const Point at(number(a[0]), number(a[1]), number(a[2]));
          const Index found = scene.grid == nullptr
                                  ? UniformGrid::none
                                  : scene.grid->nearest(at - scene.cloud.shift);
          if (found == UniformGrid::none)
            throw std::invalid_argument("there is no point to select");
          w.select(found);
        }}},
      {"deselect",
       {": no point", 0, [](Window& w, const Words&) { w.select(std::nullopt); }}},
      {"await-click",
       {": wait until a point is clicked",
        0,
        [](Window& w, const Words&) {
          while (!w.model.selected() && w.isVisible())
            QApplication::processEvents(QEventLoop::WaitForMoreEvents);
        }}},
      {"click",
       {"X Y: a click of the mouse there, pixels from the upper left of the 3D view",
        2,
        [](Window& w, const Words& a) {
          click(w.cloudView(), {number(a[0]), number(a[1])});
        }}},
      {"click-point",
       {"N: a click of the mouse where that point is seen",
        1,
        [](Window& w, const Words& a) {
          click(w.cloudView(),
                w.cloudView().pixelOf(
                    w.model.scene().points.at(static_cast<std::size_t>(number(a[0])))));
        }}},
      {"set",
       {"COMMAND OPTION VALUE: as typed into its field",
        2,
        [](Window& w, const Words& a) {
          w.controls().edit(fromName<Analysis>(a[0]), a[1], rest(a, 2));
        }}},
      {"compute",
       {"COMMAND: tensor, multiscale, curves or powerlines",
        1,
        [](Window& w, const Words& a) { w.compute(fromName<Analysis>(a[0])); }}},
      {"box",
       {"HALF: preview box around the selection; 0: none",
        1,
        [](Window& w, const Words& a) {
          const double half = number(a[0]);
          half > 0 ? w.previewAround(half) : w.preview(std::nullopt);
        }}},
      {"look",
       {"AZIMUTH ELEVATION: turn the camera, degrees",
        2,
        [](Window& w, const Words& a) {
          w.cloudView().look(number(a[0]), number(a[1]));
        }}},
      {"near",
       {"RADIUS: look at the selection from close up",
        1,
        [](Window& w, const Words& a) {
          if (!w.model.selected())
            throw std::invalid_argument("no point is selected");
          w.cloudView().lookAt(w.model.scene().cloud.points[*w.model.selected()],
                               number(a[0]));
        }}},
      {"ellipsoids",
       {"on|off: of the computed tensors, everywhere",
        1,
        [](Window& w, const Words& a) { w.cloudView().showEllipsoids(a[0] == "on"); }}},
      {"curve",
       {"N: choose a curve, from 0",
        1,
        [](Window& w, const Words& a) {
          w.selectCurve(static_cast<int>(number(a[0])));
        }}},
      {"image",
       {"curve|point: multi-scale image along the wire or curve, or around the point",
        1,
        [](Window& w, const Words& a) {
          a[0] == "curve" ? w.imageAlongCurve() : w.imageAround();
        }}},
      {"wire",
       {"N: look at that wire",
        1,
        [](Window& w, const Words& a) {
          w.selectWire(static_cast<int>(number(a[0])));
        }}},
      {"next",
       {": the next wire of the table",
        0,
        [](Window& w, const Words&) { w.wires().step(1); }}},
      {"accept",
       {": the current wire",
        0,
        [](Window& w, const Words&) { w.wires().judge(Verdict::Accepted); }}},
      {"reject",
       {": the current wire",
        0,
        [](Window& w, const Words&) { w.wires().judge(Verdict::Rejected); }}},
      {"class",
       {"N: for the points of the wire",
        1,
        [](Window& w, const Words& a) {
          w.wires().setClass(static_cast<int>(number(a[0])));
        }}},
      {"note",
       {"TEXT: on the wire",
        0,
        [](Window& w, const Words& a) { w.wires().setNote(rest(a, 0)); }}},
      {"panel",
       {"NAME: graphs, kernel, image, profile, error or wires",
        1,
        [](Window& w, const Words& a) { w.showPanel(a[0]); }}},
      {"options",
       {"COMMAND: open its page of options",
        1,
        [](Window& w, const Words& a) {
          w.controls().open(fromName<Analysis>(a[0]));
        }}},
      {"save-options",
       {"COMMAND FILE: as the tool's --config reads them",
        2,
        [](Window& w, const Words& a) {
          writeText(rest(a, 1), w.model.config(fromName<Analysis>(a[0])));
        }}},
      {"load-options",
       {"COMMAND FILE",
        2,
        [](Window& w, const Words& a) {
          w.model.settings.loadConfig(fromName<Analysis>(a[0]), rest(a, 1));
          w.controls().refresh();
        }}},
      {"shot",
       {"FILE.png: the window as it is",
        1,
        [](Window& w, const Words& a) { w.shoot(rest(a, 0)); }}},
      {"dump",
       {"FILE.json: what is shown, in numbers",
        1,
        [](Window& w, const Words& a) {
          writeText(rest(a, 0), w.state().dump(2) + "\n");
        }}},
  };
  return all;
}

} // namespace

void
runScript(Window& window, const std::string& path)
{
  std::ifstream in(path);
  if (!in)
    throw std::runtime_error(path + ": cannot be read; name a file of steps");
  std::string line;
  for (std::size_t count = 1; std::getline(in, line); ++count) {
    std::istringstream words_of(line);
    Words words;
    for (std::string word; words_of >> word;)
      words.push_back(word);
    if (words.empty() || words[0][0] == '#')
      continue;
    const auto fail = [&](const std::string& what) {
      throw std::runtime_error(path + ", line " + std::to_string(count) + ": " + what);
    };
    const auto step = steps().find(words[0]);
    if (step == steps().end())
      fail("there is no step '" + words[0] + "'; --help lists them");
    words.erase(words.begin());
    if (words.size() < step->second.words)
      fail(step->first + " needs " + step->second.meaning);
    try {
      step->second.run(window, words);
    }
    catch (const std::exception& error) {
      fail(error.what());
    }
    if (const std::string error = window.settle(); !error.empty())
      fail(error);
  }
}

std::string
scriptHelp()
{
  std::string help = "Steps of a script, one per line:\n";
  for (const auto& [name, step] : steps())
    help += "  " + name + " " + step.meaning + "\n";
  return help;
}

} // namespace linelet::view
