// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "obj_curves.h"

#include <utility>

#include "curve_lines.h"
#include "io/text_scan.h"
#include "io/vector/curve_through.h"

namespace linelet::io {

namespace {

/** Reads the curves of an OBJ text. */
class ObjReader {
public:
  explicit ObjReader(const Source& source) : source_(source) {}

  CurveNetwork
  read()
  {
    Lines lines(source_.bytes);
    for (std::string_view line; lines.next(line);) {
      number_ = lines.number();
      const std::string_view word = takeWord(line);
      if (word == "v")
        readVertex(line);
      else if (word == "l")
        readLine(line);
    }
    return std::move(network_);
  }

private:
  [[noreturn]] void
  fail(const std::string& what) const
  {
    source_.fail("line " + std::to_string(number_) + ": " + what);
  }

  void
  readVertex(std::string_view line)
  {
    Point point;
    for (double& value : point.reshaped())
      if (!parseNumber(takeWord(line), value))
        fail("a vertex needs three numbers");
    vertices_.push_back(point);
  }

  void
  readLine(std::string_view line)
  {
    std::vector<std::size_t> places;
    for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line)) {
      const std::string_view place = word.substr(0, word.find('/'));
      const auto count = static_cast<long long>(vertices_.size());
      long long value = 0;
      const bool read = parseNumber(place, value);
      if (read && value < 0)
        value += count + 1; // counted back from the latest
      if (!read || value < 1 || value > count)
        fail("'" + cleanName(word) + "' is not one of the " + std::to_string(count) +
             " vertices before it");
      places.push_back(static_cast<std::size_t>(value - 1));
    }
    if (places.size() < 2)
      fail("a line needs at least two vertices");
    Points line_vertices;
    for (std::size_t place : places)
      line_vertices.push_back(vertices_[place]);
    network_.curves.push_back(curveThrough(std::move(line_vertices)));
  }

  const Source& source_;
  Points vertices_;
  CurveNetwork network_;
  std::size_t number_ = 0;
};

} // namespace

CurveNetwork
curvesFromObj(const Source& source)
{
  return ObjReader(source).read();
}

std::string
curvesAsObj(const CurveNetwork& network, const Point& shift)
{
  std::string text = "# curves, written by linelet\n";
  appendVertices(text, network, shift, "v ");
  forEachLine(network, [&](const Curve& curve, std::size_t, std::size_t first) {
    text += 'l';
    appendPlaces(text, curve, first + 1);
  });
  return text;
}

} // namespace linelet::io
