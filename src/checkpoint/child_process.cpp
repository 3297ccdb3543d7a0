#include "child_process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>

#include "context.hpp"

namespace rupture {
namespace {

constexpr rlim_t kMostSeconds = 240;  // of processor time

void limit(decltype(RLIMIT_CPU) resource, rlim_t most) {
  const rlimit both = {most, most};
  [[maybe_unused]] const int ignored = ::setrlimit(resource, &both);
}

[[noreturn]] void be_the_child(const std::function<int()>& work) {
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, stream);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, kMostSeconds);
  // A handler of ours or of a sanitizer would report what is expected here, or continue.
  for (const int signal : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT}) std::signal(signal, SIG_DFL);
  int code = ChildEnd::kThrew;
  try {
    code = work();
  } catch (const std::exception&) {
  }
  ::_exit(code);
}

}  // namespace

ChildEnd in_child_process(const std::function<int()>& work) {
  const pid_t child = ::fork();
  if (child < 0) {
    throw MachineFailure("cannot start a process: {}; try again later", std::strerror(errno));
  }
  if (child == 0) be_the_child(work);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw Failure("lost track of a child process");
  }
  if (WIFEXITED(status)) return {WEXITSTATUS(status), 0};
  return {ChildEnd::kThrew, WTERMSIG(status)};
}

}  // namespace rupture
