// Preloaded into a tool (LD_PRELOAD), counts the calls that touch files of its working folder, and
// ends the tool at one of them or lets one of them fail. The environment says which:
//
//   FAULT_AT=n           the call to act on, counted from 1; 0 or absent: none
//   FAULT=kill           SIGKILL just before it
//   FAULT=short          a write takes half of its bytes only, which is no error
//   FAULT=<errno>        it fails with this error, and nothing happens
//   FAULT=<errno>+       the same, and so do all later calls that need room on the disk
//   FAULT_LOG=file       one line per call, in order, by which disk.py replays them
//
// Paths of the working folder are the relative ones: the tests start the tools in it. These are the
// calls that the tools make; power_cut_test.py fails if they change files by others.
#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

enum class Fault { none, kill, shorten, error, lasting_error };

struct Plan {
  long at = 0;
  Fault fault = Fault::none;
  int error = 0;
  int log = -1;
};

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

Plan read_plan() {
  Plan plan;
  if (const char* log = std::getenv("FAULT_LOG")) {
    // Far from the numbers that the tool gets, so that it sees the same ones as ever.
    const int fd = next<int(const char*, int, ...)>("open")(
        log, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    plan.log = ::fcntl(fd, F_DUPFD_CLOEXEC, 900);
  }
  const char* at = std::getenv("FAULT_AT");
  const char* fault = std::getenv("FAULT");
  if (at == nullptr || fault == nullptr) return plan;
  plan.at = std::atol(at);
  const std::string word = fault;
  plan.error = std::atoi(fault);
  plan.fault = word == "kill"       ? Fault::kill
               : word == "short"    ? Fault::shorten
               : word.back() == '+' ? Fault::lasting_error
                                    : Fault::error;
  return plan;
}

const Plan& plan() {
  static const Plan read = read_plan();
  return read;
}

long calls = 0;
std::array<bool, 1024> watched{};  // descriptors of files in the working folder

bool is_watched(int fd) {
  return fd >= 0 && static_cast<std::size_t>(fd) < watched.size() &&
         watched[static_cast<std::size_t>(fd)];
}

bool is_watched(const char* path) {
  return path[0] != '/';
}

enum class Needs { nothing, room };

// Counts a call; true if it is to fail, with errno set.
bool fails(Needs needs) {
  ++calls;
  const bool now = calls == plan().at;
  if (now && plan().fault == Fault::kill) ::raise(SIGKILL);
  const bool later =
      plan().fault == Fault::lasting_error && calls > plan().at && needs == Needs::room;
  if (plan().error == 0 || !(now || later)) return false;
  errno = plan().error;
  return true;
}

// A line of the log; the call's own errno stays.
void log(const char* format, ...) __attribute__((format(printf, 1, 2)));
void log(const char* format, ...) {
  if (plan().log < 0) return;
  const int error = errno;
  va_list arguments;
  va_start(arguments, format);
  ::vdprintf(plan().log, format, arguments);
  va_end(arguments);
  errno = error;
}

std::string hexadecimal(const void* bytes, std::size_t size) {
  constexpr const char* digits = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < size; ++i) {
    const unsigned byte = static_cast<const unsigned char*>(bytes)[i];
    text += digits[byte >> 4U];
    text += digits[byte & 15U];
  }
  return text;
}

// `done` is what the real call returned.
int logged(int done, const char* call, const char* a, const char* b = "") {
  log("%s%s %s %s\n", done == 0 ? "" : "failed-", call, a, b);
  return done;
}

// A call on an open file that gives 0, with its arguments in the log.
template <class Call>
int call_on(int fd, Needs needs, const char* name, const std::string& arguments, const Call& call) {
  if (!is_watched(fd)) return call();
  if (fails(needs)) return -1;
  return logged(call(), name, arguments.c_str());
}

// A call that gives a file another name, or takes it away.
template <class Call>
int change_name(const char* name, const char* from, const char* to, const Call& call) {
  if (!is_watched(from)) return call();
  if (fails(Needs::nothing)) return -1;
  return logged(call(), name, from, to);
}

}  // namespace

// NOLINTBEGIN: the names and signatures are those of the C library
extern "C" {

int open(const char* path, int flags, ...) {
  static auto* real = next<int(const char*, int, ...)>("open");
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  if (!is_watched(path)) return real(path, flags, mode);
  if (fails((flags & O_CREAT) != 0 ? Needs::room : Needs::nothing)) return -1;
  const int fd = real(path, flags, mode);
  const bool reads = (flags & O_ACCMODE) == O_RDONLY;
  const char* how = reads ? "read" : (flags & O_TRUNC) != 0 ? "truncate" : "write";
  log("%s %d %s %s\n", fd < 0 ? "failed-open" : "open", fd, path, how);
  if (fd >= 0) watched.at(static_cast<std::size_t>(fd)) = true;
  return fd;
}

ssize_t write(int fd, const void* bytes, size_t size) {
  static auto* real = next<ssize_t(int, const void*, size_t)>("write");
  if (!is_watched(fd)) return real(fd, bytes, size);
  if (calls + 1 == plan().at && plan().fault == Fault::shorten && size > 1) size /= 2;
  if (fails(Needs::room)) return -1;
  const ssize_t written = real(fd, bytes, size);
  if (written < 0) {
    log("failed-write %d\n", fd);
  } else {
    log("write %d %lld %s\n", fd, static_cast<long long>(::lseek(fd, 0, SEEK_CUR) - written),
        hexadecimal(bytes, static_cast<std::size_t>(written)).c_str());
  }
  return written;
}

ssize_t read(int fd, void* bytes, size_t size) {
  static auto* real = next<ssize_t(int, void*, size_t)>("read");
  if (!is_watched(fd)) return real(fd, bytes, size);
  if (fails(Needs::nothing)) return -1;
  log("read %d\n", fd);
  return real(fd, bytes, size);
}

int ftruncate(int fd, off_t length) {
  static auto* real = next<int(int, off_t)>("ftruncate");
  const std::string arguments = std::to_string(fd) + " " + std::to_string(length);
  return call_on(fd, Needs::room, "truncate", arguments, [&] { return real(fd, length); });
}

int fsync(int fd) {
  static auto* real = next<int(int)>("fsync");
  return call_on(fd, Needs::nothing, "fsync", std::to_string(fd), [&] { return real(fd); });
}

int close(int fd) {
  static auto* real = next<int(int)>("close");
  if (!is_watched(fd)) return real(fd);
  watched[static_cast<std::size_t>(fd)] = false;
  const bool failed = fails(Needs::nothing);
  const int error = errno;
  const int done = real(fd);  // Linux closes it also when it reports an error
  if (!failed) return logged(done, "close", std::to_string(fd).c_str());
  errno = error;
  return -1;
}

int rename(const char* from, const char* to) {
  static auto* real = next<int(const char*, const char*)>("rename");
  return change_name("rename", from, to, [&] { return real(from, to); });
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) {
  static auto* real = next<int(int, const char*, int, const char*, unsigned)>("renameat2");
  return change_name("rename", from, to,
                     [&] { return real(from_folder, from, to_folder, to, flags); });
}

int link(const char* from, const char* to) {
  static auto* real = next<int(const char*, const char*)>("link");
  if (!is_watched(from)) return real(from, to);
  return fails(Needs::room) ? -1 : logged(real(from, to), "link", from, to);
}

int unlink(const char* path) {
  static auto* real = next<int(const char*)>("unlink");
  return change_name("unlink", path, "", [&] { return real(path); });
}
}
// NOLINTEND
