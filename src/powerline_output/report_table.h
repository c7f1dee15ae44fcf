// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <initializer_list>
#include <string>

#include <nlohmann/json.hpp>

namespace linelet::powerline::report {

/** \brief A table of the page, in the form of page/table.mustache. */
class Table {
public:
  /** \brief A column: words are left-aligned, numbers right-aligned. */
  struct Column {
    std::string name;
    bool words = false;
  };

  /** \brief A cell; only the text is required. */
  struct Cell {
    std::string text;
    bool alarm = false;
    std::string link = {};   ///< URL
    std::string remark = {}; ///< after the text
    std::string swatch = {}; ///< color of a square before the text
  };

  explicit Table(std::initializer_list<Column> columns, const std::string& look = {})
  {
    json_["table_class"] = look;
    json_["columns"] = nlohmann::ordered_json::array();
    for (const Column& column : columns) {
      json_["columns"].push_back({{"name", column.name}, {"words", column.words}});
      words_.push_back(column.words);
    }
    json_["rows"] = nlohmann::ordered_json::array();
  }

  /** \brief Appends a row that links can reach as \a anchor. */
  void
  row(std::initializer_list<Cell> cells, const std::string& anchor = {})
  {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Cell& cell : cells)
      all.push_back({{"look", look(all.size(), cell.alarm)},
                     {"swatch", cell.swatch},
                     {"link", cell.link},
                     {"text", cell.text},
                     {"remark", cell.remark}});
    json_["rows"].push_back({{"anchor", anchor}, {"cells", std::move(all)}});
  }

  const nlohmann::ordered_json&
  json() const
  {
    return json_;
  }

private:
  std::string
  look(std::size_t column, bool alarm) const
  {
    const std::string text = words_[column] ? "text" : "";
    return alarm ? text + (text.empty() ? "bad" : " bad") : text;
  }

  nlohmann::ordered_json json_;
  std::vector<bool> words_;
};

} // namespace linelet::powerline::report
