// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ply_reader.h"

#include <algorithm>
#include <map>
#include <optional>

#include "io/columns.h"
#include "io/text_scan.h"

namespace linelet::io {

namespace {

using boost::endian::order;

struct Property {
  std::string name;
  ValueType type = ValueType::Float32;
  std::optional<ValueType> length; ///< type of the count, if this is a list
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;

  bool
  hasLists() const
  {
    return std::any_of(
        properties.begin(), properties.end(), [](const Property& property) {
          return property.length.has_value();
        });
  }

  std::size_t
  rowBytes() const
  {
    std::size_t bytes = 0;
    for (const Property& property : properties)
      bytes += sizeOf(property.type);
    return bytes;
  }
};

std::optional<ValueType>
typeOf(std::string_view name)
{
  static const std::map<std::string_view, ValueType> types = {
      {"char", ValueType::Int8},
      {"int8", ValueType::Int8},
      {"uchar", ValueType::UInt8},
      {"uint8", ValueType::UInt8},
      {"short", ValueType::Int16},
      {"int16", ValueType::Int16},
      {"ushort", ValueType::UInt16},
      {"uint16", ValueType::UInt16},
      {"int", ValueType::Int32},
      {"int32", ValueType::Int32},
      {"uint", ValueType::UInt32},
      {"uint32", ValueType::UInt32},
      {"int64", ValueType::Int64},
      {"uint64", ValueType::UInt64},
      {"float", ValueType::Float32},
      {"float32", ValueType::Float32},
      {"double", ValueType::Float64},
      {"float64", ValueType::Float64}};
  const auto place = types.find(name);
  return place == types.end() ? std::nullopt : std::optional(place->second);
}

class Reader {
public:
  explicit Reader(const Source& source) : source_(source), lines_(source.bytes) {}

  Cloud
  read()
  {
    readHeader();
    auto vertex =
        std::find_if(elements_.begin(), elements_.end(), [](const Element& element) {
          return element.name == "vertex";
        });
    if (vertex == elements_.end())
      source_.fail("the header has no element 'vertex'");
    nameProperties(*vertex);
    for (const char* name : {"x", "y", "z"})
      if (std::none_of(vertex->properties.begin(),
                       vertex->properties.end(),
                       [name](const Property& p) { return p.name == name; }))
        source_.fail(std::string("element 'vertex' has no property '") + name + "'");
    rest_ = lines_.rest();
    for (auto element = elements_.begin(); element != vertex; ++element)
      if (!skip(*element))
        source_.fail("the file ends within element '" + element->name +
                     "', before the vertices");
    readVertices(*vertex);
    Cloud cloud = cloudFromColumns(source_, std::move(columns_));
    cloud.wkt = wkt_;
    cloud.format = "PLY, " + std::string(format_);
    return cloud;
  }

private:
  [[noreturn]] void
  failHere(const std::string& what) const
  {
    source_.fail("line " + std::to_string(lines_.number()) + ": " + what);
  }

  void
  readHeader()
  {
    std::string_view line;
    if (source_.bytes.empty())
      source_.fail("the file is empty");
    if (!lines_.next(line) || takeWord(line) != "ply")
      source_.fail("not a PLY file: it does not begin with 'ply'");
    for (;;) {
      if (!lines_.next(line))
        source_.fail("the header ends without 'end_header'");
      const std::string_view whole = line;
      const std::string_view key = takeWord(line);
      if (key == "end_header")
        break;
      if (key == "format")
        format_ = takeWord(line);
      else if (key == "element")
        addElement(line);
      else if (key == "property")
        addProperty(line);
      else if (whole.rfind("comment crs ", 0) == 0)
        wkt_ = cleanName(whole.substr(12));
      else if (!key.empty() && key != "comment" && key != "obj_info")
        failHere("'" + cleanName(key.substr(0, 40)) +
                 "' is not a word of a PLY header");
    }
    if (format_ != "ascii" && format_ != "binary_little_endian" &&
        format_ != "binary_big_endian")
      source_.fail("format '" + cleanName(format_.substr(0, 40)) +
                   "' is not known; PLY has ascii, binary_little_endian and "
                   "binary_big_endian");
  }

  static void
  nameProperties(Element& element)
  {
    std::vector<std::string> names;
    for (const Property& property : element.properties) {
      std::string_view name = property.name;
      if (name.substr(0, scalar_prefix.size()) == scalar_prefix)
        name.remove_prefix(scalar_prefix.size());
      names.emplace_back(name);
    }
    names = canonicalNames(names);
    for (std::size_t i = 0; i < names.size(); ++i)
      element.properties[i].name = names[i];
  }

  void
  addElement(std::string_view line)
  {
    Element element;
    element.name = cleanName(takeWord(line));
    if (!parseNumber(takeWord(line), element.count))
      failHere("element '" + element.name + "' has no usable count");
    elements_.push_back(std::move(element));
  }

  void
  addProperty(std::string_view line)
  {
    if (elements_.empty())
      failHere("a property without an element");
    Property property;
    std::string_view type = takeWord(line);
    const auto known = [&] {
      const auto value = typeOf(type);
      if (!value)
        failHere("'" + cleanName(type.substr(0, 40)) + "' is not a type of PLY");
      return *value;
    };
    if (type == "list") {
      type = takeWord(line);
      property.length = known();
      type = takeWord(line);
    }
    property.type = known();
    property.name = takeWord(line);
    elements_.back().properties.push_back(std::move(property));
  }

  /** Reads a value of \a type from the front of rest_; false if it is missing. */
  template <class F>
  bool
  takeBinary(ValueType type, F f)
  {
    return withType(type, [&](auto zero) {
      using T = decltype(zero);
      if (rest_.size() < sizeof(T))
        return false;
      f(format_ == "binary_big_endian" ? load<T, order::big>(rest_.data())
                                       : load<T, order::little>(rest_.data()));
      rest_.remove_prefix(sizeof(T));
      return true;
    });
  }

  /** Skips the entries of a list; false if they are missing. */
  bool
  skipList(const Property& property)
  {
    std::size_t count = 0;
    const auto set = [&](auto value) { count = nearest<std::uint32_t>(value); };
    if (!takeBinary(*property.length, set) ||
        rest_.size() / sizeOf(property.type) < count)
      return false;
    rest_.remove_prefix(count * sizeOf(property.type));
    return true;
  }

  /** Skips all rows of an element before the vertices. */
  bool
  skip(const Element& element)
  {
    if (format_ == "ascii") {
      std::string_view line;
      for (std::size_t i = 0; i < element.count; ++i)
        if (!nextRow(line))
          return false;
      return true;
    }
    if (!element.hasLists()) {
      const std::size_t bytes = element.rowBytes();
      if (bytes != 0 && rest_.size() / bytes < element.count)
        return false;
      rest_.remove_prefix(bytes * element.count);
      return true;
    }
    for (std::size_t i = 0; i < element.count; ++i)
      for (const Property& property : element.properties)
        if (property.length ? !skipList(property)
                            : !takeBinary(property.type, [](auto) {}))
          return false;
    return true;
  }

  bool
  nextRow(std::string_view& line)
  {
    while (lines_.next(line))
      if (line.find_first_not_of(" \t") != std::string_view::npos)
        return true;
    return false;
  }

  void
  readVertices(const Element& vertex)
  {
    const bool ascii = format_ == "ascii";
    // A value takes at least one byte, two in text with its separator, which bounds the
    // number of rows.
    std::size_t least = 0;
    for (const Property& property : vertex.properties)
      least += ascii             ? 2
               : property.length ? sizeOf(*property.length)
                                 : sizeOf(property.type);
    const std::size_t most = (ascii ? lines_.rest().size() + 1 : rest_.size()) / least;
    for (const Property& property : vertex.properties) {
      if (property.length) {
        source_.warn("the lists '" + property.name + "' of its vertices are left out");
        continue;
      }
      columns_.push_back(
          {property.name, makeValues(property.type, std::min(vertex.count, most)), {}});
    }
    std::size_t rows = 0;
    while (rows < std::min(vertex.count, most) &&
           (ascii ? readTextRow(vertex, rows) : readBinaryRow(vertex, rows)))
      if (++rows % block_points == 0)
        source_.advance(block_points);
    if (rows == vertex.count)
      return;
    source_.endsEarly("the header says " + std::to_string(vertex.count) +
                      " vertices, but the file ends after " + std::to_string(rows) +
                      " whole ones");
    for (Column& column : columns_)
      std::visit([rows](auto& values) { values.resize(rows); }, column.values);
  }

  bool
  readBinaryRow(const Element& vertex, std::size_t row)
  {
    std::size_t next = 0;
    for (const Property& property : vertex.properties) {
      if (property.length) {
        if (!skipList(property))
          return false;
        continue;
      }
      Column& column = columns_[next++];
      const bool there = takeBinary(property.type, [&](auto value) {
        std::get<std::vector<decltype(value)>>(column.values)[row] = value;
      });
      if (!there)
        return false;
    }
    return true;
  }

  bool
  readTextRow(const Element& vertex, std::size_t row)
  {
    std::string_view line;
    if (!nextRow(line))
      return false;
    std::size_t next = 0;
    for (const Property& property : vertex.properties) {
      std::string_view word = takeWord(line);
      if (property.length) {
        std::size_t count = 0;
        if (!parseNumber(word, count))
          return failOrEnd(word, property);
        for (; count > 0 && !line.empty(); --count)
          takeWord(line);
        continue;
      }
      const bool read =
          std::visit([&](auto& values) { return parseValue(word, values[row]); },
                     columns_[next++].values);
      if (!read)
        return failOrEnd(word, property);
    }
    return true;
  }

  /** False at the end of a truncated text; otherwise throws. */
  bool
  failOrEnd(std::string_view word, const Property& property) const
  {
    if (word.empty() && lines_.rest().empty())
      return false;
    failHere(noValue(word, property.name));
  }

  const Source& source_;
  Lines lines_;
  std::string_view format_, rest_;
  std::string wkt_;
  std::vector<Element> elements_;
  std::vector<Column> columns_;
};

} // namespace

Cloud
readPly(const Source& source)
{
  return Reader(source).read();
}

} // namespace linelet::io
