// SPDX-FileCopyrightText: 2026 the linelet authors
// SPDX-License-Identifier: BSD-3-Clause

#include "signals.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <thread>

#include <poll.h>
#include <unistd.h>

#include <linelet/io/unfinished_files.h>

namespace linelet::apps {

namespace {

constexpr int patience = 1500; // milliseconds for work to end on its own

volatile std::sig_atomic_t requested = 0;
std::array<int, 2> wake; // read end, write end

void
onSignal(int)
{
  const int error = errno;
  requested = 1;
  const char byte = 0;
  [[maybe_unused]] const auto written = ::write(wake[1], &byte, 1);
  errno = error;
}

/** \brief Waits for a signal, then gives the program time to end on its own. */
void
watch(const std::string& message)
{
  char byte = 0;
  while (::read(wake[0], &byte, 1) != 1)
    if (errno != EINTR)
      return;
  pollfd second{wake[0], POLLIN, 0};
  ::poll(&second, 1, patience);
  io::removeUnfinishedFiles();
  [[maybe_unused]] const auto written =
      ::write(STDERR_FILENO, message.data(), message.size());
  ::_exit(1);
}

} // namespace

void
watchSignals(const std::string& command)
{
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  if (::pipe(wake.data()) != 0)
    return;
  std::thread(watch, "linelet " + command + ": canceled\n").detach();
  struct sigaction action {};
  action.sa_handler = onSignal;
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU}) {
    struct sigaction before {};
    ::sigaction(signal, nullptr, &before);
    const bool nohup = signal == SIGHUP && before.sa_handler == SIG_IGN;
    if (!nohup)
      ::sigaction(signal, &action, nullptr);
  }
}

bool
stopRequested()
{
  return requested != 0;
}

} // namespace linelet::apps
