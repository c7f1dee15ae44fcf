// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "render_template.h"

#include <algorithm>
#include <stdexcept>

#include <kainjow/mustache.hpp>

#include "page_files.h"

namespace linelet::powerline::report {

namespace {

namespace mustache = kainjow::mustache;
using Json = nlohmann::ordered_json;

mustache::data
toMustache(const Json& json)
{
  if (json.is_null() ||
      (json.is_string() && json.get_ref<const std::string&>().empty()))
    return mustache::data(false);
  if (json.is_boolean())
    return mustache::data(json.get<bool>());
  if (json.is_string())
    return mustache::data(json.get<std::string>());
  if (json.is_array()) {
    mustache::data list(mustache::data::type::list);
    for (const Json& item : json)
      list << toMustache(item);
    return list;
  }
  if (json.is_object()) {
    mustache::data object(mustache::data::type::object);
    for (const auto& [key, value] : json.items())
      object.set(key, toMustache(value));
    return object;
  }
  return mustache::data(json.dump());
}

const char*
textOf(const std::string& name)
{
  for (const EmbeddedText* file = page_files; file->name != nullptr; ++file)
    if (name == file->name)
      return file->text;
  throw std::logic_error("there is no file " + name + " in the folder page/");
}

} // namespace

std::string
renderTemplate(const std::string& name, const Json& data)
{
  mustache::mustache page(textOf(name));
  if (!page.is_valid())
    throw std::logic_error(name + ": " + page.error_message());
  mustache::data filled = toMustache(data);
  for (const EmbeddedText* file = page_files; file->name != nullptr; ++file) {
    const std::string text = file->text;
    filled.set(file->name, mustache::data(mustache::partial([text] { return text; })));
  }
  std::string out = page.render(filled);
  if (!page.is_valid())
    throw std::logic_error(name + ": " + page.error_message());
  // Comments at the top of a file leave empty lines.
  return out.substr(std::min(out.find_first_not_of('\n'), out.size()));
}

} // namespace linelet::powerline::report
