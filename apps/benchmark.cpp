// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <bench/runs/benchmark.h>
#include <bench/runs/benchmark_grid.h>
#include <bench/runs/benchmark_summary.h>
#include <bench/runs/random_runs.h>
#include <CLI/CLI.hpp>

#include <linelet/curves/reconstruct_curves.h>
#include <linelet/io/output_file.h>

#include "commands.h"
#include "frame.h"
#include "options.h"
#include "picture/benchmark_picture.h"
#include "picture/canvas.h"
#include "sweep.h"

namespace linelet::apps {

namespace {

using bench::BenchmarkRow;
using bench::BenchmarkRun;

/** \brief Which runs to make, and where to write their rows. */
struct BenchmarkOptions {
  std::size_t sample = 2000;
  std::uint64_t seed = 1;
  bool all = false, clean = false;
  std::vector<std::string> geometries = {"benchmark"};
  std::string out, plot, box_plot, label;
  std::vector<std::string> vary; ///< NAME=VALUE,...
  std::size_t vary_index = 0;    ///< 0: all
};

void
describe(BenchmarkOptions& s, const OptionAdder& visit)
{
  visit("sample", s.sample, "number of runs, drawn evenly from the grid");
  visit("all", s.all, "run the whole grid");
  visit("seed", s.seed, "seed of that draw");
  visit("clean", s.clean, "only noise-free runs with 128, 256 and 512 points");
  visit("out", s.out, "file of rows (.csv), one per run");
  visit("plot",
        s.plot,
        "picture (.png) of success by geometry and noise, beside that of other "
        "methods whose rows of the same runs are in --out");
  visit("box-plot",
        s.box_plot,
        "the same picture (.png) of the distances E_V, as box plots");
  visit("vary-index",
        s.vary_index,
        "only this combination of --vary, as the table numbers them; 0: all");
  visit("label",
        s.label,
        "name of the method in the rows; empty: the preset and the settings that "
        "differ from the defaults");
}

/** \brief What distinguishes rows with these settings: the preset, and every
 * reconstruction option that differs from its default. */
std::string
methodOf(const CLI::App& app, ReconstructionSettings& settings)
{
  std::string method(nameOf(settings.preset));
  describe(settings, [&](const std::string& name, const auto&, const auto&) {
    const CLI::Option* option = app.get_option("--" + name);
    const std::vector<std::string>& values = option->results();
    if (name == "preset" || values.empty() ||
        values == std::vector<std::string>{option->get_default_str()})
      return;
    method += ' ' + name;
    for (const std::string& value : values)
      method += ' ' + value;
  });
  return method;
}

/** \brief The name of the method in a row, without commas, which end a field. */
std::string
checkedLabel(const std::string& label)
{
  if (label.find_first_of(",\"\r\n") != std::string::npos)
    throw std::runtime_error("--label " + label +
                             " would break the CSV file: omit commas, quotes "
                             "and line ends");
  return label;
}

std::vector<bench::Geometry>
geometriesOf(const std::vector<std::string>& names)
{
  std::vector<bench::Geometry> geometries;
  for (const std::string& name : names)
    if (name == "benchmark" || name == "held-out") {
      const auto& group = name == "benchmark" ? bench::benchmarkGeometries()
                                              : bench::heldOutGeometries();
      geometries.insert(geometries.end(), group.begin(), group.end());
    }
    else
      geometries.push_back(fromName<bench::Geometry>(name));
  return geometries;
}

std::vector<BenchmarkRun>
runsOf(const BenchmarkOptions& options)
{
  if (options.geometries == std::vector<std::string>{"random"}) {
    if (options.all || options.clean)
      throw std::runtime_error("--geometries random has neither --all nor --clean");
    return bench::randomRuns(options.sample, static_cast<std::uint32_t>(options.seed));
  }
  const std::vector<bench::Geometry> geometries = geometriesOf(options.geometries);
  std::vector<BenchmarkRun> runs;
  if (options.clean) {
    for (const bench::Geometry geometry : geometries)
      for (const std::size_t points : {128, 256, 512}) {
        BenchmarkRun run;
        run.geometry = geometry;
        run.sampling.points = points;
        runs.push_back(run);
      }
    return runs;
  }
  const bench::BenchmarkGrid grid(geometries);
  const std::size_t count = options.all ? 0 : options.sample;
  for (const std::size_t index : grid.stratifiedSample(count, options.seed))
    runs.push_back(grid.at(index));
  return runs;
}

/** \brief The file of rows: what it already holds, and the destination of new rows. */
class RowFile {
public:
  /** \param[in] path empty: no file */
  explicit RowFile(const std::string& path) : path_(path)
  {
    if (path.empty())
      return;
    if (std::ifstream in(path); in && in.peek() != std::ifstream::traits_type::eof()) {
      try {
        old_ = bench::readCsv(in);
      }
      catch (const std::runtime_error& error) {
        throw std::runtime_error(path + ": " + error.what() + "; name another file");
      }
    }
    // Rewritten under another name: a truncated line may be lost, but never the file.
    std::ostringstream whole;
    whole << bench::benchmark_csv_header << '\n';
    for (const BenchmarkRow& row : old_)
      bench::writeCsv(whole, row);
    io::OutputFile fresh(path);
    fresh.write(whole.str());
    fresh.commit();
    out_.open(path, std::ios::app);
    check();
  }

  const std::vector<BenchmarkRow>&
  old() const
  {
    return old_;
  }

  void
  add(const BenchmarkRow& row)
  {
    if (path_.empty())
      return;
    bench::writeCsv(out_, row);
    check();
  }

private:
  void
  check()
  {
    if (!out_.flush())
      throw std::runtime_error(path_ + ": cannot be written; check that the folder "
                                       "exists, is writable and has free space");
  }

  std::string path_;
  std::ofstream out_;
  std::vector<BenchmarkRow> old_;
};

/** \brief Draws \a rows of \a method, next to the results of other methods in \a old
 * for the same \a wanted runs. */
void
plot(const std::string& path,
     const std::string& method,
     const std::vector<BenchmarkRow>& rows,
     const std::vector<BenchmarkRun>& wanted,
     const std::vector<BenchmarkRow>& old,
     BenchmarkView view)
{
  constexpr int width = 1500, height = 860;
  std::vector<MethodRows> methods = {{method, rows}};
  std::set<std::string> runs;
  for (const BenchmarkRun& run : wanted)
    runs.insert(bench::keyOf("", run));
  for (const BenchmarkRow& row : old) {
    if (row.method == method || runs.count(bench::keyOf("", row.run)) == 0)
      continue;
    auto found = std::find_if(methods.begin(), methods.end(), [&](const auto& m) {
      return m.first == row.method;
    });
    if (found == methods.end())
      found = methods.insert(methods.end(), {row.method, {}});
    found->second.push_back(row);
  }
  drawBenchmark(methods, view, width, height).save(path);
}

/** \brief Rows of \a wanted runs by \a method found in \a old, one per run; runs
 * without a row remain in \a wanted. */
std::vector<BenchmarkRow>
takeDone(const std::string& method,
         const std::vector<BenchmarkRow>& old,
         std::vector<BenchmarkRun>& wanted)
{
  std::set<std::string> wanted_keys, done_keys;
  for (const BenchmarkRun& run : wanted)
    wanted_keys.insert(bench::keyOf(method, run));
  std::vector<BenchmarkRow> done;
  for (const BenchmarkRow& row : old) {
    const std::string key = bench::keyOf(row.method, row.run);
    if (wanted_keys.count(key) > 0 && done_keys.insert(key).second)
      done.push_back(row);
  }
  const auto isDone = [&](const BenchmarkRun& run) {
    return done_keys.count(bench::keyOf(method, run)) > 0;
  };
  wanted.erase(std::remove_if(wanted.begin(), wanted.end(), isDone), wanted.end());
  return done;
}

/** \brief Every combination of varied values, with one table row each. */
int
runSweep(const BenchmarkOptions& options,
         const ReconstructionSettings& settings,
         Frame& frame)
{
  const Sweep sweep(options.vary);
  if (options.vary_index > sweep.size())
    throw std::runtime_error("--vary-index " + std::to_string(options.vary_index) +
                             " is beyond the " + std::to_string(sweep.size()) +
                             " combinations");
  const std::vector<BenchmarkRun> runs = runsOf(options);
  RowFile file(options.out);
  std::string header = "index";
  for (const std::string& name : sweep.names())
    header += "  " + name;
  std::printf("%s: runs  success  E_V  E_H  E_Len  E_Com  ms\n", header.c_str());
  nlohmann::ordered_json results = nlohmann::ordered_json::array();
  const std::size_t first = options.vary_index > 0 ? options.vary_index - 1 : 0;
  const std::size_t end = options.vary_index > 0 ? options.vary_index : sweep.size();
  for (std::size_t index = first; index < end; ++index) {
    ReconstructionSettings varied = settings;
    std::vector<BenchmarkRun> wanted = sweep.apply(index, varied, runs);
    const std::string method =
        (options.label.empty() ? std::string(nameOf(varied.preset))
                               : checkedLabel(options.label)) +
        ' ' + sweep.label(index);
    std::vector<BenchmarkRow> rows = takeDone(method, file.old(), wanted);
    bench::runBenchmark(
        method,
        wanted,
        [&](const Points& points, ProgressMonitor* monitor) {
          return reconstructCurves(points, varied, monitor);
        },
        [&](const BenchmarkRow& row) {
          file.add(row);
          rows.push_back(row);
        },
        frame.threads,
        &frame.monitor);
    const bench::RunSummary all = bench::summarize(rows);
    std::printf("%5zu  %s: %zu  %.3f  %.3f  %.3f  %.3f  %.3f  %.1f\n",
                index + 1,
                sweep.label(index).c_str(),
                all.runs,
                all.success,
                all.e_v,
                all.e_h,
                all.e_len,
                all.e_com,
                all.milliseconds);
    std::fflush(stdout);
    results.push_back({{"index", index + 1},
                       {"values", sweep.label(index)},
                       {"runs", all.runs},
                       {"success", all.success},
                       {"e_v", all.e_v},
                       {"e_h", all.e_h}});
  }
  frame.summary["combinations"] = results;
  return frame.finish();
}

} // namespace

int
runBenchmark(const std::vector<std::string>& arguments)
{
  Frame frame("benchmark",
              "Reconstructs noisy test geometries over a grid of noises (127,050 runs) "
              "or a sample of it, every run in one thread, several at a time. Runs "
              "whose rows are already in --out are not repeated.");
  BenchmarkOptions options;
  ReconstructionSettings settings;
  addOptions(frame.app, options);
  frame.writes(options.out);
  frame.writes(options.plot);
  frame.writes(options.box_plot);
  frame.app
      .add_option(
          "--vary",
          options.vary,
          "try every combination of values of options: NAME=VALUE,... (or "
          "VALUE|... where values have commas), repeated for each NAME; points, "
          "distribution, jitter and outliers are those of the samples")
      ->allow_extra_args(false)
      ->type_name("NAME=VALUE,...");
  frame.app
      .add_option("--geometries",
                  options.geometries,
                  "names, or benchmark (the ten), or held-out (nine outside its "
                  "grid); or random: shapes drawn at random, at any scale")
      ->delimiter(',')
      ->type_name("NAME,...")
      ->default_str(options.geometries.front());
  addOptions(frame.app, settings);
  frame.parse(arguments);
  settings.threads = 1;
  for (const std::string* picture : {&options.plot, &options.box_plot})
    if (!picture->empty())
      checkPictureOutput(*picture);
  if (!options.vary.empty())
    return runSweep(options, settings, frame);
  const std::string method = options.label.empty() ? methodOf(frame.app, settings)
                                                   : checkedLabel(options.label);

  const std::vector<BenchmarkRun> wanted = runsOf(options);
  RowFile file(options.out);
  std::vector<BenchmarkRun> missing = wanted;
  std::vector<BenchmarkRow> rows = takeDone(method, file.old(), missing);
  frame.summary["method"] = method;
  frame.summary["resumed"] = rows.size();
  bench::runBenchmark(
      method,
      missing,
      [&](const Points& points, ProgressMonitor* monitor) {
        return reconstructCurves(points, settings, monitor);
      },
      [&](const BenchmarkRow& row) {
        file.add(row);
        rows.push_back(row);
      },
      frame.threads,
      &frame.monitor);

  std::printf("%s, %zu runs\n%s",
              method.c_str(),
              rows.size(),
              bench::summaryTable(rows).c_str());
  if (!options.plot.empty() && !rows.empty())
    plot(options.plot, method, rows, wanted, file.old(), BenchmarkView::Success);
  if (!options.box_plot.empty() && !rows.empty())
    plot(options.box_plot, method, rows, wanted, file.old(), BenchmarkView::Distances);
  const bench::RunSummary all_runs = bench::summarize(rows);
  frame.summary["runs"] = rows.size();
  frame.summary["success"] = all_runs.success;
  frame.summary["mean_ms"] = all_runs.milliseconds;
  return frame.finish();
}

} // namespace linelet::apps
