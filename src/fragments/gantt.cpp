// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <linelet/fragments/gantt.h>

#include <algorithm>
#include <cstdarg>
#include <cstdio>

namespace linelet::fragments {

namespace {

// Pixels.
constexpr int left = 130, width = 760, row = 22, head = 26, gap = 14, foot = 30;

std::string
escaped(const std::string& text)
{
  std::string result;
  for (const char letter : text)
    switch (letter) {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    default:
      result += letter;
    }
  return result;
}

[[gnu::format(printf, 1, 2)]] std::string
format(const char* form, ...)
{
  char text[256];
  std::va_list values;
  va_start(values, form);
  std::vsnprintf(text, sizeof(text), form, values);
  va_end(values);
  return text;
}

std::string
textAt(double x, double y, const char* anchor, const std::string& words)
{
  return format("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">", x, y, anchor) +
         escaped(words) + "</text>\n";
}

} // namespace

std::string
ganttChart(const std::vector<NamedSchedule>& schedules,
           const std::vector<std::string>& devices)
{
  double end = 0, longest = 0;
  for (const NamedSchedule& named : schedules) {
    end = std::max(end, makespan(named.schedule));
    for (const Assignment& bar : named.schedule)
      longest = std::max(longest, bar.end - bar.begin);
  }
  const double scale = end > 0 ? width / end : 0;
  const int block = head + row * static_cast<int>(devices.size()) + gap;
  const int height = block * static_cast<int>(schedules.size()) + foot;
  std::string svg = format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" "
                           "height=\"%d\" font-family=\"sans-serif\" "
                           "font-size=\"12\">\n"
                           "<rect width=\"100%%\" height=\"100%%\" fill=\"white\"/>\n",
                           left + width + 20,
                           height);
  int top = 0;
  for (const NamedSchedule& named : schedules) {
    svg += textAt(left,
                  top + 18,
                  "start",
                  named.name + format(", %.6g s", makespan(named.schedule)));
    for (std::size_t d = 0; d < devices.size(); ++d)
      svg += textAt(left - 8,
                    top + head + row * (static_cast<double>(d) + 0.7),
                    "end",
                    devices[d]);
    for (const Assignment& bar : named.schedule) {
      const double share = longest > 0 ? (bar.end - bar.begin) / longest : 0;
      svg += format("<rect x=\"%.2f\" y=\"%d\" width=\"%.2f\" height=\"%d\" "
                    "fill=\"hsl(210,60%%,%.0f%%)\" stroke=\"white\" "
                    "stroke-width=\"0.5\"><title>%zu</title></rect>\n",
                    left + bar.begin * scale,
                    top + head + row * static_cast<int>(bar.device) + 2,
                    (bar.end - bar.begin) * scale,
                    row - 4,
                    75 - 45 * share,
                    bar.fragment + 1);
    }
    top += block;
  }
  svg += format("<path d=\"M%d %dh%d\" stroke=\"black\"/>\n", left, top, width);
  for (int i = 0; i <= 4; ++i)
    svg +=
        textAt(left + width * i / 4.0, top + 18, "middle", format("%.4g", end * i / 4));
  return svg + "</svg>\n";
}

} // namespace linelet::fragments
