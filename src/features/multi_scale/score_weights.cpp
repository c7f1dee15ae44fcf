// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/features/score_weights.h>

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace linelet {

namespace {

using Member = double ScoreWeights::*;

constexpr std::string_view published = "published"; // the defaults

constexpr std::array<std::pair<std::string_view, Member>, 8> members = {
    {{"linearity", &ScoreWeights::linearity},
     {"scale", &ScoreWeights::scale},
     {"area", &ScoreWeights::area},
     {"depth", &ScoreWeights::depth},
     {"step", &ScoreWeights::step},
     {"width", &ScoreWeights::width},
     {"neighbors", &ScoreWeights::neighbors},
     {"second", &ScoreWeights::second}}};

Member
memberCalled(std::string_view name)
{
  std::string message =
      "unknown weight of a score '" + std::string(name) + "', use NAME=VALUE of";
  for (const auto& [known, member] : members) {
    if (name == known)
      return member;
    message += " " + std::string(known);
  }
  throw std::invalid_argument(message);
}

double
numberIn(std::string_view text)
{
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || !std::isfinite(value))
    throw std::invalid_argument("weight of a score '" + std::string(text) +
                                "' is not a finite number");
  return value;
}

} // namespace

ScoreWeights::ScoreWeights(std::string_view text)
{
  if (text == published)
    return;
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    const std::string_view item = text.substr(0, comma);
    const std::size_t equal = item.find('=');
    const Member member = memberCalled(item.substr(0, equal));
    this->*member = numberIn(equal == std::string_view::npos ? std::string_view()
                                                             : item.substr(equal + 1));
    text =
        comma == std::string_view::npos ? std::string_view() : text.substr(comma + 1);
  }
}

std::string
ScoreWeights::name() const
{
  const ScoreWeights usual;
  std::string text;
  for (const auto& [name, member] : members) {
    if (this->*member == usual.*member)
      continue;
    std::array<char, 32> number{};
    const auto end =
        std::to_chars(number.data(), number.data() + number.size(), this->*member);
    text += (text.empty() ? "" : ",") + std::string(name) + "=" +
            std::string(number.data(), end.ptr);
  }
  return text.empty() ? std::string(published) : text;
}

} // namespace linelet
