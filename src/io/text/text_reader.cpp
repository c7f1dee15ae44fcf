// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "text_reader.h"

#include <algorithm>
#include <cmath>

#include "io/columns.h"
#include "io/las/las_format.h"
#include "io/text_scan.h"

namespace linelet::io {

namespace {

/** A column of numbers: integers until the first that is not. */
class Numbers {
public:
  bool
  add(std::string_view word)
  {
    std::int64_t whole = 0;
    double real = NAN; // empty fields are undefined
    if (whole_ && parseNumber(word, whole)) {
      integers_.push_back(whole);
      return true;
    }
    if (!word.empty() && !parseNumber(word, real))
      return false;
    if (whole_) {
      whole_ = false;
      reals_.assign(integers_.begin(), integers_.end());
      integers_ = {};
    }
    reals_.push_back(real);
    return true;
  }

  void
  resize(std::size_t count)
  {
    if (whole_)
      integers_.resize(count);
    else
      reals_.resize(count);
  }

  /** The values in the smallest type that is customary for \a name and holds them. */
  Values
  take(const std::string& name)
  {
    if (!whole_)
      return name == "scan_angle"
                 ? Values(std::vector<float>(reals_.begin(), reals_.end()))
                 : Values(std::move(reals_));
    std::vector<ValueType> types = {ValueType::Int32, ValueType::Int64};
    if (name == "x" || name == "y" || name == "z" || name == "gps_time")
      types = {ValueType::Float64};
    else if (name == "scan_angle")
      types.insert(types.begin(), ValueType::Int8);
    else if (isColor(name) || name == "nir" || name == "intensity" ||
             name == "point_source_id")
      types.insert(types.begin(), ValueType::UInt16);
    else if (isLasName(name))
      types.insert(types.begin(), ValueType::UInt8);
    for (ValueType type : types) {
      Values values = withType(type, [&](auto zero) {
        using T = decltype(zero);
        const bool fits =
            std::all_of(integers_.begin(), integers_.end(), [](auto value) {
              return representable<T>(value);
            });
        return fits ? Values(std::vector<T>(integers_.begin(), integers_.end()))
                    : Values(std::vector<T>());
      });
      if (io::size(values) == integers_.size())
        return values;
    }
    return std::move(integers_);
  }

private:
  bool whole_ = true;
  std::vector<std::int64_t> integers_;
  std::vector<double> reals_;
};

std::string_view
trim(std::string_view word, std::string_view what = " \t")
{
  const std::size_t first = word.find_first_not_of(what);
  if (first == std::string_view::npos)
    return {};
  return word.substr(first, word.find_last_not_of(what) - first + 1);
}

bool
isNumber(std::string_view word)
{
  double value = 0;
  return parseNumber(word, value);
}

/** Whether \a word would be a number with a decimal point instead of its comma. */
bool
hasDecimalComma(std::string_view word)
{
  const std::size_t comma = word.find(',');
  if (comma == std::string_view::npos)
    return false;
  std::string with_point(word);
  with_point[comma] = '.';
  return isNumber(with_point);
}

/** The text of a comment; null if \a line is not one. */
const char*
commentOf(std::string_view line)
{
  for (const std::string_view mark : {"#", "//", "%"})
    if (line.substr(0, mark.size()) == mark)
      return line.data() + mark.size();
  return nullptr;
}

class Reader {
public:
  explicit Reader(const Source& source) : source_(source), lines_(source.bytes)
  {
    if (source.bytes.empty())
      source.fail("the file is empty");
    if (source.bytes.substr(0, 3) == "\xEF\xBB\xBF") // byte order mark
      lines_ = Lines(source.bytes.substr(3));
  }

  Cloud
  read()
  {
    for (std::string_view line; lines_.next(line);) {
      line = trim(line);
      if (line.empty())
        continue;
      if (const char* comment = commentOf(line)) {
        if (rows_ == 0 && !begun_)
          comment_ = trim({comment, static_cast<std::size_t>(line.end() - comment)});
        continue;
      }
      if (!begun_ && begin(line))
        continue;
      if (!addRow(line))
        break;
    }
    if (!begun_ && !comment_.empty())
      begin(comment_); // a header without points
    return finish();
  }

private:
  [[noreturn]] void
  fail(const std::string& what) const
  {
    source_.fail("line " + std::to_string(lines_.number()) + ": " + what);
  }

  [[noreturn]] void
  failForCommas() const
  {
    fail("numbers have decimal commas; write them with points, as in 1.5");
  }

  void
  split(std::string_view line)
  {
    words_.clear();
    if (separator_ == ' ') {
      for (std::string_view word = takeWord(line); !word.empty(); word = takeWord(line))
        words_.push_back(word);
      return;
    }
    for (;;) {
      const std::size_t end = line.find(separator_);
      words_.push_back(trim(line.substr(0, end)));
      if (end == std::string_view::npos)
        break;
      line.remove_prefix(end + 1);
    }
  }

  /** Drops the empty word after a trailing separator. */
  void
  dropEnd(std::size_t columns)
  {
    if (words_.size() > columns && words_.back().empty())
      words_.pop_back();
  }

  void
  setSeparator(std::string_view line)
  {
    separator_ = line.find(';') != std::string_view::npos   ? ';'
                 : line.find(',') != std::string_view::npos ? ','
                                                            : ' ';
  }

  void
  takeNames()
  {
    for (std::string_view word : words_)
      names_.emplace_back(trim(word, "\"'"));
    names_ = canonicalNames(names_);
  }

  /** Inspects the first line that is not a comment; true if it holds names. */
  bool
  begin(std::string_view line)
  {
    begun_ = true;
    setSeparator(line);
    split(line);
    dropEnd(1);
    if (std::none_of(words_.begin(), words_.end(), isNumber)) {
      if (std::any_of(words_.begin(), words_.end(), hasDecimalComma))
        failForCommas();
      takeNames();
      numbers_.resize(names_.size());
      return true;
    }
    const std::size_t columns = words_.size();
    const char separator = separator_;
    if (!comment_.empty()) {
      setSeparator(comment_);
      split(comment_);
      if (words_.size() == columns &&
          std::none_of(words_.begin(), words_.end(), isNumber))
        takeNames();
    }
    separator_ = separator;
    if (names_.empty())
      nameColumns(columns);
    numbers_.resize(names_.size());
    return false;
  }

  void
  nameColumns(std::size_t columns)
  {
    if (columns < 2)
      fail("a point needs at least two numbers, and here is one");
    for (std::size_t i = 0; i < columns; ++i)
      names_.push_back(i < 3 ? std::string(1, "xyz"[i])
                             : "column_" + std::to_string(i + 1));
  }

  /** False if the last line of the file is incomplete. */
  bool
  addRow(std::string_view line)
  {
    split(line);
    dropEnd(names_.size());
    if (words_.size() != names_.size()) {
      if (words_.size() < names_.size() && lines_.rest().empty() && rows_ > 0) {
        source_.endsEarly("the file ends within line " +
                          std::to_string(lines_.number()) + ", after " +
                          std::to_string(words_.size()) + " of " +
                          std::to_string(names_.size()) + " values");
        return false;
      }
      fail("there are " + std::to_string(words_.size()) + " values instead of " +
           std::to_string(names_.size()));
    }
    if (rows_ == 0)
      dropWords();
    for (std::size_t i = 0; i < names_.size(); ++i)
      if (!dropped_[i] && !numbers_[i].add(words_[i])) {
        if (hasDecimalComma(words_[i]))
          failForCommas();
        fail("'" + cleanName(words_[i].substr(0, 40)) + "' is not a number for '" +
             names_[i] + "'");
      }
    if (++rows_ % block_points == 0)
      source_.advance(block_points);
    return true;
  }

  /** Leaves out attributes that are words. */
  void
  dropWords()
  {
    dropped_.assign(names_.size(), false);
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const bool place = names_[i] == "x" || names_[i] == "y" || names_[i] == "z";
      if (hasDecimalComma(words_[i]))
        failForCommas();
      if (place || words_[i].empty() || isNumber(words_[i]))
        continue;
      dropped_[i] = true;
      source_.warn("attribute '" + names_[i] + "' is left out: it holds words");
    }
  }

  Cloud
  finish()
  {
    if (!begun_)
      source_.fail("the file holds no points");
    dropped_.resize(names_.size());
    std::vector<Column> columns;
    for (std::size_t i = 0; i < names_.size(); ++i)
      if (!dropped_[i])
        columns.push_back({names_[i], numbers_[i].take(names_[i]), {}});
    if (names_ == std::vector<std::string>{"x", "y"}) // a planar drawing
      columns.push_back({"z", std::vector<double>(rows_, 0.0), {}});
    Cloud cloud = cloudFromColumns(source_, std::move(columns));
    cloud.format = "text";
    return cloud;
  }

  const Source& source_;
  Lines lines_;
  bool begun_ = false;
  char separator_ = ' ';
  std::string_view comment_;
  std::vector<std::string_view> words_;
  std::vector<std::string> names_;
  std::vector<Numbers> numbers_;
  std::vector<bool> dropped_;
  std::size_t rows_ = 0;
};

} // namespace

Cloud
readText(const Source& source)
{
  return Reader(source).read();
}

} // namespace linelet::io
