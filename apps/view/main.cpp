// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QSurfaceFormat>
#include <QTimer>
#include <QVTKOpenGLNativeWidget.h>
#include <vtkObject.h>

#include <linelet/io/output_file.h>

#include "script.h"
#include "window.h"

using namespace linelet::view;

namespace {

struct Options {
  std::vector<std::string> files;
  std::string truth, script, shot, dump;
};

/** \brief Whether there is a display for a window. Without one, Qt would abort the
 * program. */
bool
hasDisplay()
{
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
    if (const char* value = std::getenv(name); value != nullptr && *value != '\0')
      return true;
  return false;
}

/** \brief Runs without user interaction. \return exit code */
int
runUnattended(Window& window, const Options& options)
{
  try {
    if (const std::string error = window.settle(); !error.empty())
      throw std::runtime_error(error);
    if (!options.script.empty())
      runScript(window, options.script);
    if (!options.shot.empty())
      window.shoot(options.shot);
    if (!options.dump.empty()) {
      linelet::io::OutputFile file(options.dump);
      file.write(window.state().dump(2) + "\n");
      file.commit();
    }
    return 0;
  }
  catch (const std::exception& error) {
    std::fprintf(stderr, "linelet-view: %s\n", error.what());
    return 1;
  }
}

} // namespace

int
main(int argc, char** argv)
{
  Options options;
  CLI::App app("Shows point clouds, curves and power lines, and what they were derived "
               "from.",
               "linelet-view");
  app.footer(scriptHelp());
  app.add_option("FILES",
                 options.files,
                 "point files, folders, .vpc, lists, curves, a folder of powerlines");
  app.add_option("--truth", options.truth, "true curves, to compare others with");
  app.add_option("--script", options.script, "run the steps in this file and exit");
  app.add_option("--shot", options.shot, "write the window to this PNG and exit");
  app.add_option("--dump", options.dump, "write what is shown to this JSON and exit");
  CLI11_PARSE(app, argc, argv);

  if (!hasDisplay()) {
    std::fprintf(stderr,
                 "linelet-view: there is no display for its window; log in with "
                 "ssh -X, or run it under xvfb-run\n");
    return 1;
  }
  vtkObject::GlobalWarningDisplayOff();
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
  QApplication application(argc, argv);
  Window window;
  window.show();
  if (!options.files.empty())
    window.open(options.files, options.truth);
  if (options.script.empty() && options.shot.empty() && options.dump.empty())
    return QApplication::exec();
  int code = 0;
  QTimer::singleShot(0, [&] {
    code = runUnattended(window, options);
    QApplication::exit(code);
  });
  QApplication::exec();
  return code;
}
