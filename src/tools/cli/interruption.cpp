#include "cli/interruption.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <ctime>
#include <tuple>

namespace rupture::tools {
namespace {

// NOLINTBEGIN(*-avoid-non-const-global-variables): nothing else can a signal handler write, which
// may run in any thread
std::atomic<int> caught = 0;
std::atomic<double> caught_at = 0.0;  // [s]
static_assert(decltype(caught)::is_always_lock_free && decltype(caught_at)::is_always_lock_free,
              "else a handler may not write them");
// NOLINTEND(*-avoid-non-const-global-variables)

extern "C" void on_signal(int signal) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  const double seconds = static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  if (caught == 0) {
    caught_at = seconds;  // first: another signal may come in between
    caught = signal;
  } else if (seconds - caught_at > 0.5 && signal != SIGXCPU) {  // the kernel repeats that one
    end_by_signal(signal);
  }
}

}  // namespace

void catch_interruptions() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU}) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler == SIG_IGN) continue;
    action = {};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART | SA_NODEFER;  // so that it can end the process
    sigaction(signal, &action, nullptr);
  }
}

int interruption() {
  return caught;
}

void occupy_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) >= 0) continue;
    std::ignore = ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

bool nobody_reads_output() {
  pollfd output = {STDOUT_FILENO, POLLOUT, 0};
  return ::poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0;
}

void end_by_signal(int signal) {
  ::prctl(PR_SET_DUMPABLE, 0);  // or SIGXCPU would leave a core
  std::signal(signal, SIG_DFL);
  raise(signal);
  std::_Exit(128 + signal);  // a process with the number 1, as in a container, is still there
}

}  // namespace rupture::tools
