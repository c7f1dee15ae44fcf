// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "source.h"

namespace linelet::io {

namespace {

/** Length of the UTF-8 sequence that starts with \a lead, 0 if none may. */
std::size_t
sequenceLength(unsigned char lead)
{
  if (lead < 0x80)
    return 1;
  if (lead >= 0xC2 && lead < 0xE0)
    return 2;
  if (lead >= 0xE0 && lead < 0xF0)
    return 3;
  return lead >= 0xF0 && lead < 0xF5 ? 4 : 0;
}

bool
isSequence(std::string_view text, std::size_t at, std::size_t length)
{
  if (length == 0 || at + length > text.size())
    return false;
  for (std::size_t i = 1; i < length; ++i)
    if ((static_cast<unsigned char>(text[at + i]) & 0xC0) != 0x80)
      return false;
  // Overlong forms and surrogates are invalid; JSON writers reject them.
  const auto lead = static_cast<unsigned char>(text[at]);
  const auto next = static_cast<unsigned char>(length > 1 ? text[at + 1] : '\x80');
  return !(lead == 0xE0 && next < 0xA0) && !(lead == 0xED && next > 0x9F) &&
         !(lead == 0xF0 && next < 0x90) && !(lead == 0xF4 && next > 0x8F);
}

} // namespace

std::string
cleanName(std::string_view text)
{
  std::string name;
  for (std::size_t at = 0; at < text.size();) {
    const auto letter = static_cast<unsigned char>(text[at]);
    const std::size_t length = sequenceLength(letter);
    if (letter < 0x20 || letter == 0x7F || !isSequence(text, at, length)) {
      name += '_';
      ++at;
      continue;
    }
    name += text.substr(at, length);
    at += length;
  }
  const std::size_t first = name.find_first_not_of(' ');
  if (first == std::string::npos)
    return {};
  return name.substr(first, name.find_last_not_of(' ') - first + 1);
}

std::string
UniqueNames::take(const std::string& asked)
{
  const auto [place, fresh] = used_.emplace(asked, 1);
  if (fresh)
    return asked;
  std::string name;
  do
    name = asked + "_" + std::to_string(++place->second);
  while (!used_.emplace(name, 1).second);
  return name;
}

} // namespace linelet::io
