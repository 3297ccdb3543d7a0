#include "cli/interruption.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <ctime>
#include <tuple>

namespace rupture::tools {
namespace {

constexpr std::array kSignals = {SIGINT, SIGTERM, SIGHUP};

// NOLINTBEGIN(*-avoid-non-const-global-variables): nothing else can a signal handler write
volatile std::sig_atomic_t noted = 0;
volatile double noted_at = 0.0;  // [s]
// NOLINTEND(*-avoid-non-const-global-variables)

extern "C" void note(int signal) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  const double seconds = static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  if (noted == 0) {
    noted = signal;
    noted_at = seconds;
  } else if (seconds - noted_at > 0.5) {
    std::signal(signal, SIG_DFL);
    raise(signal);
  }
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  sigaction(signal, nullptr, &action);
  if (action.sa_handler == SIG_IGN) return;
  action = {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

}  // namespace

InterruptionNoted::InterruptionNoted() {
  noted = 0;
  for (const int signal : kSignals) handle(signal, note);
}

InterruptionNoted::~InterruptionNoted() {
  for (const int signal : kSignals) handle(signal, SIG_DFL);
}

int InterruptionNoted::signal() {
  return noted;
}

void occupy_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) >= 0) continue;
    std::ignore = ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

void ignore_broken_pipes() {
  std::signal(SIGPIPE, SIG_IGN);
}

bool nobody_reads_output() {
  pollfd output = {STDOUT_FILENO, POLLOUT, 0};
  return ::poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0;
}

void end_by_signal(int signal) {
  std::signal(signal, SIG_DFL);
  raise(signal);
  std::abort();  // the signal ends the process
}

}  // namespace rupture::tools
