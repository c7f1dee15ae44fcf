// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <linelet/fragments/dispatcher.h>
#include <linelet/fragments/gantt.h>
#include <linelet/io/file_error.h>
#include <linelet/io/output_file.h>

#include "commands.h"
#include "frame.h"
#include "options.h"

namespace linelet::apps {

namespace {

using namespace fragments;

/** \brief A table of expected times, as read from a file. */
struct TimeTable {
  std::vector<std::string> devices;
  std::vector<double> points;
  ExpectedTimes times{0, 0};
};

std::vector<std::string>
cellsOf(std::string line)
{
  if (!line.empty() && line.back() == '\r')
    line.pop_back();
  std::vector<std::string> cells;
  std::istringstream text(line);
  for (std::string cell; std::getline(text, cell, ',');) {
    cell.erase(0, cell.find_first_not_of(" \""));
    cell.erase(cell.find_last_not_of(" \"") + 1);
    cells.push_back(cell);
  }
  return cells;
}

double
numberIn(const std::string& cell, const std::string& file, std::size_t line)
{
  std::size_t used = 0;
  double value = -1;
  try {
    value = std::stod(cell, &used);
  }
  catch (const std::exception&) {
  }
  if (used == 0 || used != cell.size() || !(value >= 0) || value > 1e300)
    throw io::FileError(file + ": line " + std::to_string(line) + " has '" + cell +
                        "' where a number, 0 or more, is expected");
  return value;
}

TimeTable
readTimes(const std::string& path)
{
  std::ifstream file(path);
  std::string line;
  if (!file || !std::getline(file, line))
    throw io::FileError(path + ": cannot be read, or is empty; name a CSV file of a "
                               "column points and one per device");
  const std::vector<std::string> names = cellsOf(line);
  TimeTable table;
  for (const std::string& name : names)
    if (name != "fragment" && name != "points")
      table.devices.push_back(name);
  if (table.devices.empty())
    throw io::FileError(path + ": names no device; its first line is to be "
                               "points,DEVICE,...");
  std::vector<double> seconds;
  for (std::size_t number = 2; std::getline(file, line); ++number) {
    const std::vector<std::string> cells = cellsOf(line);
    if (cells.empty())
      continue;
    if (cells.size() != names.size())
      throw io::FileError(path + ": line " + std::to_string(number) + " has " +
                          std::to_string(cells.size()) + " values, the first " +
                          std::to_string(names.size()));
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (names[i] == "points")
        table.points.push_back(numberIn(cells[i], path, number));
      else if (names[i] != "fragment")
        seconds.push_back(numberIn(cells[i], path, number));
  }
  table.times = {seconds.size() / table.devices.size(), table.devices.size()};
  for (std::size_t f = 0; f < table.times.fragments(); ++f)
    for (std::size_t d = 0; d < table.devices.size(); ++d)
      table.times(f, d) = seconds[f * table.devices.size() + d];
  if (table.points.empty()) // use the times on the first device instead
    for (std::size_t f = 0; f < table.times.fragments(); ++f)
      table.points.push_back(table.times(f, 0));
  return table;
}

} // namespace

int
runSchedule(const std::vector<std::string>& arguments)
{
  Frame frame("schedule",
              "Simulates how fragments are assigned to devices by each of the five "
              "heuristics of Grasso et al. (2015): the time until all are done, "
              "compared with that of Sufferage, and the time and number of fragments "
              "of every device. The table has one line per fragment and one column of "
              "seconds per device, named in the first line; an optional column points "
              "holds the sizes, and a column fragment is ignored.");
  std::string etc, gantt;
  const OptionAdder add(frame.app);
  add("etc", etc, "CSV file of expected times to compute, seconds; required");
  add("gantt", gantt, "SVG file to draw the schedules into");
  frame.reads(etc);
  frame.writes(gantt);
  frame.parse(arguments);
  if (etc.empty())
    throw std::invalid_argument(
        "--etc is required; it names the CSV file of expected times");
  if (!gantt.empty())
    io::checkWritable(gantt);

  const TimeTable table = readTimes(etc);
  std::vector<NamedSchedule> schedules;
  schedules.reserve(Names<Heuristic>::table.size());
  for (const auto& [heuristic, name] : Names<Heuristic>::table)
    schedules.push_back(
        {std::string(name), simulate(heuristic, table.times, table.points)});
  const double reference = makespan(schedules.front().schedule);
  std::printf("%-12s %12s %9s", "heuristic", "seconds", "");
  for (const std::string& device : table.devices)
    std::printf("  %18s", device.c_str());
  std::printf("\n");
  frame.summary["fragments"] = table.times.fragments();
  frame.summary["devices"] = table.devices;
  for (const NamedSchedule& named : schedules) {
    const double end = makespan(named.schedule);
    const double share = end > 0 ? reference / end : 1;
    std::printf("%-12s %12.6g %8.2f%%", named.name.c_str(), end, 100 * share);
    auto& summary = frame.summary["heuristics"][named.name];
    summary["seconds"] = end;
    summary["of_sufferage"] = share;
    for (std::size_t d = 0; d < table.devices.size(); ++d) {
      double busy = 0;
      std::size_t count = 0;
      for (const Assignment& assignment : named.schedule)
        if (assignment.device == d) {
          busy += assignment.end - assignment.begin;
          ++count;
        }
      std::printf("  %12.6g [%3zu]", busy, count);
      summary["devices"].push_back({{"seconds", busy}, {"fragments", count}});
    }
    std::printf("\n");
  }
  if (!gantt.empty()) {
    io::OutputFile file(gantt);
    file.write(ganttChart(schedules, table.devices));
    file.commit();
  }
  return frame.finish();
}

} // namespace linelet::apps
