// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "pcd_reader.h"

#include <algorithm>
#include <optional>

#include <lzf.h>

#include "io/columns.h"
#include "io/text_scan.h"

namespace linelet::io {

namespace {

struct Field {
  std::string name;
  ValueType type = ValueType::Float32;
  std::size_t count = 1;
};

std::optional<ValueType>
typeOf(std::string_view letter, std::size_t bytes)
{
  const std::string key = std::string(letter) + std::to_string(bytes);
  static constexpr const char* keys[] = {
      "I1", "U1", "I2", "U2", "I4", "U4", "I8", "U8", "F4", "F8"};
  for (std::size_t i = 0; i < 10; ++i)
    if (key == keys[i])
      return static_cast<ValueType>(i);
  return {};
}

class Reader {
public:
  explicit Reader(const Source& source) : source_(source), lines_(source.bytes) {}

  Cloud
  read()
  {
    readHeader();
    makeFields();
    if (data_ == "ascii")
      readAscii();
    else if (data_ == "binary")
      readBinary();
    else if (data_ == "binary_compressed")
      readCompressed();
    else
      source_.fail("DATA '" + cleanName(data_) +
                   "' is not known; PCD has ascii, binary and binary_compressed");
    // Fields called _ are padding.
    columns_.erase(
        std::remove_if(columns_.begin(),
                       columns_.end(),
                       [](const Column& column) { return column.name == "_"; }),
        columns_.end());
    Cloud cloud = cloudFromColumns(source_, std::move(columns_));
    cloud.wkt = wkt_;
    cloud.format = "PCD, " + std::string(data_);
    return cloud;
  }

private:
  [[noreturn]] void
  failHere(const std::string& what) const
  {
    source_.fail("line " + std::to_string(lines_.number()) + ": " + what);
  }

  std::size_t
  count(std::string_view word) const
  {
    std::size_t value = 0;
    if (!parseNumber(word, value))
      failHere("'" + cleanName(word.substr(0, 40)) + "' is not a count");
    return value;
  }

  void
  readHeader()
  {
    for (std::string_view line; data_.empty();) {
      if (!lines_.next(line))
        source_.fail(source_.bytes.empty() ? "the file is empty"
                                           : "the header ends without a DATA line");
      if (line.rfind("# crs ", 0) == 0)
        wkt_ = cleanName(line.substr(6));
      const std::string_view key = takeWord(line);
      if (key.empty() || key.front() == '#')
        continue;
      std::vector<std::string_view> words;
      for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line))
        words.push_back(word);
      if (key == "FIELDS" || key == "COLUMNS")
        names_ = words;
      else if (key == "SIZE")
        sizes_ = words;
      else if (key == "TYPE")
        types_ = words;
      else if (key == "COUNT")
        counts_ = words;
      else if (key == "VIEWPOINT")
        checkViewpoint(words);
      else if (key == "VERSION" || words.empty())
        continue;
      else if (key == "WIDTH")
        width_ = count(words.front());
      else if (key == "HEIGHT")
        height_ = count(words.front());
      else if (key == "POINTS")
        points_ = count(words.front());
      else if (key == "DATA")
        data_ = words.front();
      else
        failHere("'" + cleanName(key.substr(0, 40)) +
                 "' is not a word of a PCD header; there is no DATA line before it");
    }
  }

  void
  checkViewpoint(const std::vector<std::string_view>& words)
  {
    for (std::size_t i = 0; i < words.size(); ++i) {
      double value = 0;
      if (!parseNumber(words[i], value) || value != (i == 3 ? 1 : 0))
        return source_.warn("the viewpoint of the sensor is not kept");
    }
  }

  void
  makeFields()
  {
    if (names_.empty())
      source_.fail("the header has no FIELDS line");
    const auto check = [&](const std::vector<std::string_view>& list,
                           const char* what) {
      if (!list.empty() && list.size() != names_.size())
        source_.fail("the header has " + std::to_string(names_.size()) +
                     " FIELDS, but " + std::to_string(list.size()) + " of " + what);
    };
    check(sizes_, "SIZE");
    check(types_, "TYPE");
    check(counts_, "COUNT");
    std::size_t values = 0;
    const auto names = canonicalNames({names_.begin(), names_.end()});
    for (std::size_t i = 0; i < names.size(); ++i) {
      Field field{names[i]};
      const std::size_t bytes = sizes_.empty() ? 4 : count(sizes_[i]);
      const std::string_view letter = types_.empty() ? "F" : types_[i];
      const auto type = typeOf(letter, bytes);
      if (!type)
        source_.fail("field '" + field.name + "' has TYPE " + cleanName(letter) +
                     " of SIZE " + std::to_string(bytes) + ", which PCD does not know");
      field.type = *type;
      field.count = counts_.empty() ? 1 : count(counts_[i]);
      if (field.count > 65536 || (values += field.count) > 65536)
        source_.fail("COUNT says more than 65536 values per point");
      row_bytes_ += field.count * sizeOf(field.type);
      fields_.push_back(field);
    }
    if (row_bytes_ == 0)
      source_.fail("COUNT says that points have no values");
    if (!points_) {
      if (!width_ || (height_ && *height_ != 0 && *width_ > SIZE_MAX / *height_))
        source_.fail("the header has no usable POINTS or WIDTH and HEIGHT");
      points_ = *width_ * height_.value_or(1);
    }
  }

  void
  makeColumns(std::size_t points)
  {
    for (const Field& field : fields_)
      for (std::size_t i = 0; i < field.count; ++i)
        columns_.push_back(
            {field.count == 1 ? field.name : field.name + "_" + std::to_string(i),
             makeValues(field.type, points),
             {}});
  }

  /** Number of complete points in the file, at most that of its header. */
  std::size_t
  wholePoints(std::size_t there) const
  {
    if (*points_ > there)
      source_.endsEarly("the header says " + std::to_string(*points_) +
                        " points, but the file ends after " + std::to_string(there) +
                        " whole ones");
    return std::min(*points_, there);
  }

  void
  readBinary()
  {
    const std::string_view data = lines_.rest();
    const std::size_t points = wholePoints(data.size() / row_bytes_);
    makeColumns(points);
    std::size_t at = 0;
    for (Column& column : columns_)
      at += readColumn(column, data.data() + at, row_bytes_);
  }

  /** Compressed points are stored field by field: all x, then all y, ... */
  void
  readCompressed()
  {
    const std::string_view data = lines_.rest();
    if (data.size() < 8)
      return source_.fail("the file ends before the sizes of its compressed data");
    const std::size_t packed = load<std::uint32_t>(data.data());
    const std::size_t size = load<std::uint32_t>(data.data() + 4);
    if (packed > data.size() - 8)
      source_.fail("the file ends after " + std::to_string(data.size() - 8) + " of " +
                   std::to_string(packed) +
                   " compressed bytes; what is cut off cannot be unpacked");
    // Three bytes of LZF unpack to at most 264.
    if (size / 88 > packed || *points_ > size / row_bytes_ ||
        *points_ * row_bytes_ != size)
      source_.fail("the compressed data say they unpack to " + std::to_string(size) +
                   " bytes, which is not what " + std::to_string(*points_) +
                   " points of " + std::to_string(row_bytes_) + " bytes need");
    std::string plain(size, '\0');
    // liblzf returns 0 on error, and reads a first byte even if there is none.
    const bool whole = packed == 0 || size == 0
                           ? packed == size
                           : lzf_decompress(data.data() + 8,
                                            static_cast<unsigned>(packed),
                                            plain.data(),
                                            static_cast<unsigned>(size)) == size;
    if (!whole)
      source_.fail("the compressed data are damaged");
    makeColumns(*points_);
    std::size_t at = 0, column = 0;
    for (const Field& field : fields_) {
      const std::size_t stride = field.count * sizeOf(field.type);
      for (std::size_t i = 0; i < field.count; ++i)
        readColumn(
            columns_[column++], plain.data() + at + i * sizeOf(field.type), stride);
      at += stride * *points_;
    }
  }

  static std::size_t
  readColumn(Column& column, const char* at, std::size_t stride)
  {
    return std::visit(
        [&](auto& values) {
          using T = typename std::decay_t<decltype(values)>::value_type;
          for (T& value : values) {
            value = load<T>(at);
            at += stride;
          }
          return sizeof(T);
        },
        column.values);
  }

  void
  readAscii()
  {
    makeColumns(0);
    // Every value takes at least one character and a separator.
    const std::size_t most = lines_.rest().size() / (2 * columns_.size()) + 1;
    for (Column& column : columns_)
      std::visit([&](auto& values) { values.reserve(std::min(*points_, most)); },
                 column.values);
    std::size_t points = 0;
    for (std::string_view line; points < *points_ && lines_.next(line);) {
      if (line.find_first_not_of(" \t") == std::string_view::npos)
        continue;
      if (!readRow(line)) {
        for (Column& column : columns_)
          std::visit([&](auto& values) { values.resize(points); }, column.values);
        break;
      }
      if (++points % block_points == 0)
        source_.advance(block_points);
    }
    wholePoints(points);
  }

  /** False if the last line of the file is incomplete. */
  bool
  readRow(std::string_view line)
  {
    for (Column& column : columns_) {
      const std::string_view word = takeWord(line, " \t,;");
      const bool read = std::visit(
          [&](auto& values) { return parseValue(word, values.emplace_back()); },
          column.values);
      if (!read && word.empty() && lines_.rest().empty())
        return false;
      if (!read)
        failHere(noValue(word, column.name));
    }
    return true;
  }

  const Source& source_;
  Lines lines_;
  std::vector<std::string_view> names_, sizes_, types_, counts_;
  std::optional<std::size_t> width_, height_, points_;
  std::string_view data_;
  std::string wkt_;
  std::vector<Field> fields_;
  std::size_t row_bytes_ = 0;
  std::vector<Column> columns_;
};

} // namespace

Cloud
readPcd(const Source& source)
{
  return Reader(source).read();
}

} // namespace linelet::io
