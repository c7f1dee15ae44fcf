// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "nrrd_header.h"

#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "io/text_scan.h"

namespace linelet::io {

namespace {

const std::map<std::string_view, ValueType>&
typeNames()
{
  static const std::map<std::string_view, ValueType> names = {
      {"signed char", ValueType::Int8},
      {"int8", ValueType::Int8},
      {"int8_t", ValueType::Int8},
      {"uchar", ValueType::UInt8},
      {"unsigned char", ValueType::UInt8},
      {"uint8", ValueType::UInt8},
      {"uint8_t", ValueType::UInt8},
      {"short", ValueType::Int16},
      {"short int", ValueType::Int16},
      {"signed short", ValueType::Int16},
      {"signed short int", ValueType::Int16},
      {"int16", ValueType::Int16},
      {"int16_t", ValueType::Int16},
      {"ushort", ValueType::UInt16},
      {"unsigned short", ValueType::UInt16},
      {"unsigned short int", ValueType::UInt16},
      {"uint16", ValueType::UInt16},
      {"uint16_t", ValueType::UInt16},
      {"int", ValueType::Int32},
      {"signed int", ValueType::Int32},
      {"int32", ValueType::Int32},
      {"int32_t", ValueType::Int32},
      {"uint", ValueType::UInt32},
      {"unsigned int", ValueType::UInt32},
      {"uint32", ValueType::UInt32},
      {"uint32_t", ValueType::UInt32},
      {"float", ValueType::Float32},
      {"double", ValueType::Float64}};
  return names;
}

std::optional<std::size_t>
componentsOf(SampleKind kind)
{
  switch (kind) {
  case SampleKind::Symmetric:
    return 6;
  case SampleKind::MaskedSymmetric:
    return 7;
  case SampleKind::Matrix:
    return 9;
  case SampleKind::Number:
    break;
  }
  return {};
}

std::string_view
trimmed(std::string_view text)
{
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos)
    return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

class Header {
public:
  explicit Header(const Source& source) : source_(source), lines_(source.bytes) {}

  NrrdHeader
  read()
  {
    readLines();
    result_.type = type();
    result_.encoding = field("encoding");
    // Text and single bytes have no byte order.
    const bool ordered = sizeOf(result_.type) > 1 && result_.encoding != "ascii" &&
                         result_.encoding != "text" && result_.encoding != "txt";
    result_.big_endian = field("endian", ordered ? "" : "little") == "big";
    for (const char* unknown :
         {"data file", "datafile", "line skip", "byte skip", "lineskip", "byteskip"})
      if (fields_.count(unknown) > 0 && field(unknown) != "0")
        source_.fail("the header has '" + std::string(unknown) +
                     "'; only volumes in one file with their header are read");
    findAxes();
    result_.data = lines_.rest();
    return result_;
  }

private:
  void
  readLines()
  {
    std::string_view line;
    if (!lines_.next(line) || line.substr(0, 6) != "NRRD00")
      source_.fail("not an NRRD file: it does not begin with NRRD000");
    while (lines_.next(line) && !line.empty()) {
      const std::size_t colon = line.find(':');
      if (line.front() == '#' || line.substr(colon, 2) == ":=")
        continue;
      if (colon == std::string_view::npos)
        source_.fail("line " + std::to_string(lines_.number()) +
                     " of the header is not 'field: value'");
      fields_[line.substr(0, colon)] = trimmed(line.substr(colon + 1));
    }
  }

  /** \brief The value of a field; if it is missing, a nonempty \a fallback. */
  std::string_view
  field(std::string_view name, std::string_view fallback = {}) const
  {
    const auto found = fields_.find(name);
    if (found != fields_.end())
      return found->second;
    if (fallback.empty())
      source_.fail("the header has no '" + std::string(name) + "'");
    return fallback;
  }

  ValueType
  type() const
  {
    const std::string_view name = field("type");
    const auto found = typeNames().find(name);
    if (found == typeNames().end())
      source_.fail("type '" + cleanName(name.substr(0, 40)) +
                   "' is not read; use a number of up to 32 bits or double");
    return found->second;
  }

  std::vector<std::string_view>
  words(std::string_view name) const
  {
    std::string_view text = field(name);
    std::vector<std::string_view> result;
    for (std::string_view word = takeWord(text); !word.empty(); word = takeWord(text))
      result.push_back(word);
    return result;
  }

  /** \brief The vectors of a field, (a,b,c) or none, each of three numbers. */
  std::vector<std::optional<Point>>
  vectors(std::string_view name) const
  {
    std::string_view text = field(name);
    std::vector<std::optional<Point>> result;
    while (!(text = trimmed(text)).empty()) {
      if (text.substr(0, 4) == "none") {
        result.emplace_back();
        text.remove_prefix(4);
        continue;
      }
      const std::size_t end = text.find(')');
      std::string_view inside = text.substr(0, end);
      Point vector;
      bool whole = end != std::string_view::npos && inside.substr(0, 1) == "(";
      inside.remove_prefix(inside.empty() ? 0 : 1);
      for (Eigen::Index a = 0; a < 3; ++a)
        whole = parseNumber(takeWord(inside, ", \t"), vector[a]) && whole;
      if (!whole || !takeWord(inside, ", \t").empty() || !vector.allFinite())
        source_.fail("'" + std::string(name) +
                     "' is not a list of vectors of three numbers, (x,y,z)");
      result.emplace_back(vector);
      text.remove_prefix(end + 1);
    }
    return result;
  }

  /** \brief The kind of tensor on an axis of this kind (empty: not stated) and size. */
  SampleKind
  kindOf(std::string_view kind, std::size_t size) const
  {
    if (kind == "3D-symmetric-matrix" || (kind.empty() && size == 6))
      return SampleKind::Symmetric;
    if (kind == "3D-masked-symmetric-matrix" || (kind.empty() && size == 7))
      return SampleKind::MaskedSymmetric;
    if (kind == "3D-matrix" || (kind.empty() && size == 9))
      return SampleKind::Matrix;
    source_.fail("its fourth axis is not a tensor (3D-symmetric-matrix, "
                 "3D-masked-symmetric-matrix or 3D-matrix)");
  }

  void
  findAxes()
  {
    std::vector<std::size_t> sizes;
    double all = 1;
    for (const std::string_view word : words("sizes")) {
      std::size_t size = 0;
      if (!parseNumber(word, size) || size == 0)
        source_.fail("'" + cleanName(word.substr(0, 40)) + "' is not a size");
      sizes.push_back(size);
      all *= static_cast<double>(size);
    }
    constexpr double most = 4294967294. * 9; // points have numbers of 32 bits
    if (sizes.size() < 3 || sizes.size() > 4 || all > most)
      source_.fail("its sizes are not those of a volume of numbers or tensors");
    std::vector<std::string_view> kinds(sizes.size());
    if (fields_.count("kinds") > 0)
      kinds = words("kinds");
    std::vector<std::optional<Point>> directions;
    if (fields_.count("space directions") > 0)
      directions = vectors("space directions");
    if (kinds.size() != sizes.size() ||
        (!directions.empty() && directions.size() != sizes.size()))
      source_.fail("the header has " + std::to_string(sizes.size()) +
                   " sizes but a different number of kinds or space directions");
    std::size_t tensor = sizes.size(); // its axis
    if (sizes.size() == 4) {
      tensor = 0;
      for (std::size_t a = 0; a < sizes.size(); ++a)
        if (kinds[a].find("matrix") != std::string_view::npos ||
            (!directions.empty() && !directions[a]))
          tensor = a;
      result_.kind =
          kindOf(kinds[tensor] == "???" || kinds[tensor] == "none" ? std::string_view()
                                                                   : kinds[tensor],
                 sizes[tensor]);
      if (componentsOf(result_.kind) != sizes[tensor])
        source_.fail("a tensor has another number of components than its axis");
    }
    place(sizes, directions, tensor);
  }

  void
  place(const std::vector<std::size_t>& sizes,
        const std::vector<std::optional<Point>>& directions,
        std::size_t tensor)
  {
    std::vector<std::string_view> spacings;
    if (fields_.count("spacings") > 0)
      spacings = words("spacings");
    std::size_t step = 1, axis = 0;
    for (std::size_t a = 0; a < sizes.size(); step *= sizes[a], ++a) {
      if (a == tensor) {
        result_.components = sizes[a];
        result_.component_step = step;
        continue;
      }
      result_.sizes[axis] = sizes[a];
      result_.steps[axis] = step;
      const auto column = static_cast<Eigen::Index>(axis++);
      if (!directions.empty()) {
        if (!directions[a])
          source_.fail("an axis of space has no direction");
        result_.directions.col(column) = *directions[a];
      }
      else if (a < spacings.size()) {
        double spacing = 0;
        if (!parseNumber(spacings[a], spacing) || !std::isfinite(spacing))
          source_.fail("'" + cleanName(spacings[a].substr(0, 40)) +
                       "' is not a spacing");
        result_.directions(column, column) = spacing;
      }
    }
    if (fields_.count("space origin") > 0) {
      const auto origin = vectors("space origin");
      if (origin.size() != 1 || !origin.front())
        source_.fail("'space origin' is not a single vector");
      result_.origin = *origin.front();
    }
    if (fields_.count("measurement frame") > 0) {
      const auto axes = vectors("measurement frame");
      if (axes.size() != 3 || !axes[0] || !axes[1] || !axes[2])
        source_.fail("'measurement frame' is not three vectors");
      for (Eigen::Index a = 0; a < 3; ++a)
        result_.frame.col(a) = *axes[static_cast<std::size_t>(a)];
    }
  }

  const Source& source_;
  Lines lines_;
  std::map<std::string_view, std::string_view> fields_;
  NrrdHeader result_;
};

} // namespace

NrrdHeader
readNrrdHeader(const Source& source)
{
  return Header(source).read();
}

} // namespace linelet::io
