#include <fcntl.h>
#include <grp.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include "tool_test.hpp"

namespace rupture::testing {
namespace {

/// A file in memory that collects one output stream.
class Capture {
 public:
  Capture() : fd_(::memfd_create("capture", MFD_CLOEXEC)) {
    if (fd_ < 0) throw std::runtime_error("no file in memory could be made");
  }
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;
  ~Capture() { ::close(fd_); }

  int fd() const { return fd_; }

  std::string text() const {
    std::string all;
    std::array<char, 65536> buffer{};
    ::lseek(fd_, 0, SEEK_SET);
    for (ssize_t got = 0; (got = ::read(fd_, buffer.data(), buffer.size())) > 0;) {
      all.append(buffer.data(), static_cast<std::size_t>(got));
    }
    return all;
  }

 private:
  int fd_;
};

bool limit(decltype(RLIMIT_CPU) resource, std::uint64_t most) {
  const rlimit both = {most, most};
  return ::setrlimit(resource, &both) == 0;
}

bool become(std::uint32_t user) {
  return ::setgroups(0, nullptr) == 0 && ::setgid(user) == 0 && ::setuid(user) == 0;
}

bool redirect(const RunOptions& options, int out, int err) {
  const int to = options.standard_output.empty()
                     ? out
                     : ::open(options.standard_output.c_str(), O_WRONLY | O_CLOEXEC);
  return to >= 0 && ::dup2(to, STDOUT_FILENO) >= 0 && ::dup2(err, STDERR_FILENO) >= 0;
}

/// In the child: everything between fork and exec.
[[noreturn]] void become_program(char* const* argv, const RunOptions& options, int out, int err) {
  constexpr std::uint64_t most_seconds = 120;
  for (const auto& [name, value] : options.environment) {
    ::setenv(name.c_str(), value.c_str(), 1);
  }
  const bool ready = redirect(options, out, err) &&
                     (options.folder.empty() || ::chdir(options.folder.c_str()) == 0) &&
                     limit(RLIMIT_CORE, 0) && limit(RLIMIT_CPU, most_seconds) &&
                     (!options.largest_file || limit(RLIMIT_FSIZE, *options.largest_file)) &&
                     (!options.memory || limit(RLIMIT_AS, *options.memory)) &&
                     (!options.user || become(*options.user));
  if (ready) ::execv(argv[0], argv);
  ::_exit(kCannotStart);
}

/// The exit code and the peak of the memory, once the program has ended.
Outcome end_of(pid_t child) {
  int status = 0;
  rusage usage{};
  while (::wait4(child, &status, 0, &usage) < 0) {
    if (errno != EINTR) throw std::runtime_error("the program was lost");
  }
  Outcome outcome;
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  outcome.peak_memory = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  return outcome;
}

}  // namespace

Outcome run_program(const std::vector<std::string>& arguments, const RunOptions& options) {
  std::vector<std::string> words = arguments;
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  const Capture out, err;
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("no process could be started");
  if (child == 0) become_program(argv.data(), options, out.fd(), err.fd());
  Outcome outcome = end_of(child);
  outcome.out = out.text();
  outcome.err = err.text();
  return outcome;
}

}  // namespace rupture::testing
