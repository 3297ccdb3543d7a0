// Preloaded into a tool (LD_PRELOAD), counts the calls that touch files of its working folder, and
// ends the tool at one of them or lets one of them fail. The environment says which:
//
//   FAULT_AT=n           the call to act on, counted from 1; 0 or absent: none
//   FAULT=kill           SIGKILL just before it
//   FAULT=short          a write takes half of its bytes only, which is no error
//   FAULT=inode          files that are renamed have another inode number by their new name
//   FAULT=<errno>        it fails with this error, and nothing happens
//   FAULT=<errno>+       the same, and so do all later calls that need room on the disk
//   FAULT_LOG=file       one line per call, in order, by which disk.py replays them
//
// Paths of the working folder are the relative ones: the tests start the tools in it. These are the
// calls that the tools make; power_cut_test.py fails if they change files by others.
#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdlib>
#include <set>
#include <span>
#include <string>
#include <tuple>

namespace {

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

std::string setting(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

// Far from the numbers that the tool gets, so that it sees the same ones as ever; -1 without a log.
int open_log() {
  const std::string log = setting("FAULT_LOG");
  if (log.empty()) return -1;
  const int fd = next<int(const char*, int, ...)>("open")(
      log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  return ::fcntl(fd, F_DUPFD_CLOEXEC, 900);
}

struct Plan {
  long at = std::atol(setting("FAULT_AT").c_str());
  std::string fault = setting("FAULT");
  int error = std::atoi(fault.c_str());  // 0 for a word
  int log = open_log();
};

const Plan& plan() {
  static const Plan read;
  return read;
}

long calls = 0;
std::set<std::string> new_names;   // by which files were renamed
std::array<bool, 1024> watched{};  // descriptors of files in the working folder

bool is_watched(int fd) {
  const auto number = static_cast<std::size_t>(fd);
  return number < watched.size() && watched[number];
}

bool is_watched(const char* path) {
  return path[0] != '/';
}

enum class Needs { nothing, room };

// Counts a call; true if it is to fail, with errno set.
bool fails(Needs needs) {
  ++calls;
  const bool now = calls == plan().at;
  if (now && plan().fault == "kill") ::raise(SIGKILL);
  const bool later = plan().fault.ends_with('+') && calls > plan().at && needs == Needs::room;
  if (plan().error == 0 || !(now || later)) return false;
  errno = plan().error;
  return true;
}

// A line of the log; the call's own errno stays.
template <class... Values>
void log(fmt::format_string<Values...> format, Values&&... values) {
  if (plan().log < 0) return;
  const int error = errno;
  const std::string line = fmt::format(format, std::forward<Values>(values)...);
  ::dprintf(plan().log, "%s\n", line.c_str());
  errno = error;
}

// A call that gives 0, on an open file or of names, with the words of its line in the log.
template <class Call, class... Words>
int counted(bool is_ours, Needs needs, const Call& call, const Words&... words) {
  if (!is_ours) return call();
  if (fails(needs)) return -1;
  const int done = call();
  log("{}{}", done == 0 ? "" : "failed-", fmt::join(std::tuple(words...), " "));
  return done;
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
  log("{} {} {} {}", fd < 0 ? "failed-open" : "open", fd, path, how);
  if (fd >= 0) watched.at(static_cast<std::size_t>(fd)) = true;
  return fd;
}

ssize_t write(int fd, const void* bytes, size_t size) {
  static auto* real = next<ssize_t(int, const void*, size_t)>("write");
  if (!is_watched(fd)) return real(fd, bytes, size);
  if (calls + 1 == plan().at && plan().fault == "short" && size > 1) size /= 2;
  if (fails(Needs::room)) return -1;
  const ssize_t written = real(fd, bytes, size);
  if (written < 0) {
    log("failed-write {}", fd);
  } else {
    const std::span done(static_cast<const unsigned char*>(bytes), static_cast<size_t>(written));
    log("write {} {} {:02x}", fd, ::lseek(fd, 0, SEEK_CUR) - written, fmt::join(done, ""));
  }
  return written;
}

ssize_t read(int fd, void* bytes, size_t size) {
  static auto* real = next<ssize_t(int, void*, size_t)>("read");
  if (!is_watched(fd)) return real(fd, bytes, size);
  if (fails(Needs::nothing)) return -1;
  log("read {}", fd);
  return real(fd, bytes, size);
}

int ftruncate(int fd, off_t length) {
  static auto* real = next<int(int, off_t)>("ftruncate");
  const auto call = [&] { return real(fd, length); };
  return counted(is_watched(fd), Needs::room, call, "truncate", fd, length);
}

int fsync(int fd) {
  static auto* real = next<int(int)>("fsync");
  const auto call = [&] { return real(fd); };
  return counted(is_watched(fd), Needs::nothing, call, "fsync", fd);
}

int close(int fd) {
  static auto* real = next<int(int)>("close");
  if (!is_watched(fd)) return real(fd);
  watched[static_cast<std::size_t>(fd)] = false;
  const auto call = [&] { return real(fd); };
  const int done = counted(true, Needs::nothing, call, "close", fd);
  if (done != 0) call();  // Linux closes it also when it reports an error
  return done;
}

int lstat(const char* path, struct stat* about) {
  static auto* real = next<int(const char*, struct stat*)>("lstat");
  const int done = real(path, about);
  if (plan().fault == "inode" && new_names.contains(path)) about->st_ino = ~about->st_ino;
  return done;
}

int rename(const char* from, const char* to) {
  static auto* real = next<int(const char*, const char*)>("rename");
  const auto call = [&] { return real(from, to); };
  new_names.insert(to);
  return counted(is_watched(from), Needs::nothing, call, "rename", from, to);
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to, unsigned flags) {
  static auto* real = next<int(int, const char*, int, const char*, unsigned)>("renameat2");
  const auto call = [&] { return real(from_folder, from, to_folder, to, flags); };
  new_names.insert(to);
  return counted(is_watched(from), Needs::nothing, call, "rename", from, to);
}

int link(const char* from, const char* to) {
  static auto* real = next<int(const char*, const char*)>("link");
  const auto call = [&] { return real(from, to); };
  return counted(is_watched(from), Needs::room, call, "link", from, to);
}

int unlink(const char* path) {
  static auto* real = next<int(const char*)>("unlink");
  const auto call = [&] { return real(path); };
  return counted(is_watched(path), Needs::nothing, call, "unlink", path);
}
}
// NOLINTEND
