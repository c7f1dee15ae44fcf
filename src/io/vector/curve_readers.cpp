// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "curve_readers.h"

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "io/text/text_scan.h"

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
        value += count + 1; // counted back from the newest
      if (!read || value < 1 || value > count)
        fail("'" + cleanName(word) + "' is none of the " + std::to_string(count) +
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

/** Words of a text, wherever its lines end. */
class Words {
public:
  explicit Words(const Source& source) : source_(source), rest_(source.bytes) {}

  std::string_view
  next()
  {
    return takeWord(rest_, " \t\r\n");
  }

  template <class T>
  T
  number(const char* of)
  {
    const std::string_view word = next();
    T value{};
    if (!parseNumber(word, value))
      source_.fail(word.empty() ? std::string("it ends before its ") + of
                                : "'" + cleanName(word.substr(0, 40)) +
                                      "' is not a number of its " + of);
    return value;
  }

  Point
  point(const char* of)
  {
    Point p;
    for (double& value : p.reshaped())
      value = number<double>(of);
    return p;
  }

private:
  const Source& source_;
  std::string_view rest_;
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<std::string> properties;
};

/** The elements of an ASCII PLY file up to its end_header, which \a words is left at.
 */
std::vector<PlyElement>
plyElements(const Source& source, Words& words)
{
  if (words.next() != "ply" || words.next() != "format" || words.next() != "ascii")
    source.fail("is not an ASCII PLY file, the only kind from which curves are read");
  std::vector<PlyElement> elements;
  Lines lines(source.bytes);
  for (std::string_view line; lines.next(line);) {
    std::string_view rest = line;
    const std::string_view word = takeWord(rest);
    if (word == "element") {
      PlyElement element;
      element.name = takeWord(rest);
      if (!parseNumber(takeWord(rest), element.count))
        source.fail("its element '" + cleanName(element.name) + "' has no count");
      elements.push_back(std::move(element));
    }
    else if (word == "property" && !elements.empty()) {
      if (takeWord(rest) == "list")
        source.fail("has lists (faces?), of which no curves are made");
      elements.back().properties.emplace_back(takeWord(rest));
    }
    else if (word == "end_header") {
      while (words.next() != "end_header")
        ;
      return elements;
    }
  }
  source.fail("its header has no end");
}

/** Rows of the elements of a PLY file, as numbers by name. */
template <class Row>
void
forEachPlyRow(const Source& source, Row row)
{
  Words words(source);
  for (const PlyElement& element : plyElements(source, words)) {
    std::map<std::string, double> values;
    for (std::size_t i = 0; i < element.count; ++i) {
      for (const std::string& property : element.properties)
        values[property] = words.number<double>(element.name.c_str());
      row(element.name, values);
    }
  }
}

/** \a value as a place among \a count. */
std::size_t
placeOf(const Source& source, double value, std::size_t count)
{
  if (!(value >= 0 && value < static_cast<double>(count)))
    source.fail("a line has the vertex " + std::to_string(value) + " of " +
                std::to_string(count));
  return static_cast<std::size_t>(value);
}

} // namespace

Curve
curveThrough(Points vertices)
{
  Curve curve;
  curve.closed = vertices.size() > 2 && vertices.front() == vertices.back();
  if (curve.closed) {
    vertices.pop_back();
    curve.front.kind = curve.back.kind = EndKind::Loop;
  }
  curve.points = std::move(vertices);
  return curve;
}

CurveNetwork
curvesFromObj(const Source& source)
{
  return ObjReader(source).read();
}

CurveNetwork
curvesFromPly(const Source& source)
{
  Points vertices;
  CurveNetwork network;
  Points line;
  std::size_t last = 0;
  double curve = -1;
  const auto finish = [&] {
    if (line.size() > 1)
      network.curves.push_back(curveThrough(std::move(line)));
    line.clear();
  };
  forEachPlyRow(source, [&](const std::string& element, auto& row) {
    if (element == "vertex")
      vertices.emplace_back(row["x"], row["y"], row["z"]);
    if (element != "edge")
      return;
    const std::size_t from = placeOf(source, row["vertex1"], vertices.size()),
                      to = placeOf(source, row["vertex2"], vertices.size());
    // Consecutive edges are one curve, unless a property separates them.
    if (line.empty() || from != last || row["curve"] != curve) {
      finish();
      line.push_back(vertices[from]);
    }
    line.push_back(vertices[to]);
    last = to;
    curve = row["curve"];
  });
  finish();
  return network;
}

CurveNetwork
curvesFromVtk(const Source& source)
{
  Words words(source);
  Points vertices;
  CurveNetwork network;
  if (source.bytes.substr(0, source.bytes.find("DATASET")).find("ASCII") ==
      std::string_view::npos)
    source.fail("is not an ASCII VTK file, the only kind from which curves are read");
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (word == "POINTS") {
      const auto count = words.number<std::size_t>("POINTS");
      words.next(); // their type
      for (std::size_t i = 0; i < count; ++i)
        vertices.push_back(words.point("POINTS"));
    }
    else if (word == "LINES") {
      const auto count = words.number<std::size_t>("LINES");
      words.next(); // how many numbers follow
      for (std::size_t i = 0; i < count; ++i) {
        Points line;
        for (auto left = words.number<std::size_t>("LINES"); left > 0; --left)
          line.push_back(vertices[placeOf(
              source, words.number<double>("LINES"), vertices.size())]);
        network.curves.push_back(curveThrough(std::move(line)));
      }
      return network;
    }
  }
  return network;
}

CurveNetwork
curvesFromCsv(const Source& source)
{
  Lines lines(source.bytes);
  std::string_view line;
  lines.next(line);
  const auto takeCell = [](std::string_view& rest) {
    const std::string_view cell = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), cell.size() + 1));
    return cell;
  };
  std::array<std::size_t, 5> places{}; // in a row, from 1
  constexpr std::array<std::string_view, 5> names = {"curve", "x", "y", "z", "closed"};
  for (std::size_t place = 1; !line.empty(); ++place) {
    const std::string_view name = takeCell(line);
    for (std::size_t i = 0; i < names.size(); ++i)
      if (name == names[i])
        places[i] = place;
  }
  for (std::size_t i = 0; i < 4; ++i)
    if (places[i] == 0)
      source.fail("its first line names no column '" + std::string(names[i]) +
                  "'; curves have curve, x, y and z");
  CurveNetwork network;
  std::map<std::string, std::size_t, std::less<>> curves;
  while (lines.next(line)) {
    if (line.empty())
      continue;
    std::array<std::string_view, 5> cells;
    for (std::size_t place = 1; !line.empty(); ++place) {
      const std::string_view cell = takeCell(line);
      for (std::size_t i = 0; i < cells.size(); ++i)
        if (places[i] == place)
          cells[i] = cell;
    }
    Point p;
    for (int axis = 0; axis < 3; ++axis)
      if (!parseNumber(cells[static_cast<std::size_t>(axis) + 1], p[axis]))
        source.fail("line " + std::to_string(lines.number()) +
                    ": a vertex needs three numbers");
    const auto [found, fresh] =
        curves.emplace(std::string(cells[0]), network.curves.size());
    if (fresh) {
      network.curves.emplace_back();
      Curve& curve = network.curves.back();
      curve.closed = cells[4] == "1";
      if (curve.closed)
        curve.front.kind = curve.back.kind = EndKind::Loop;
    }
    network.curves[found->second].points.push_back(p);
  }
  return network;
}

} // namespace linelet::io
