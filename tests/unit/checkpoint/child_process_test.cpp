// Work in a child process: how it ended is told apart, and nothing of it reaches this process.
#include "../../../src/checkpoint/child_process.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <string_view>

#include "rupture/model/error.hpp"

namespace rupture::testing {

void expect_end(const ChildEnd& end, int code, int signal) {
  EXPECT_EQ(end.code, code);
  EXPECT_EQ(end.signal, signal);
}

// A handler that hides a crash.
extern "C" void leave_quietly(int) {
  ::_exit(0);
}

TEST(ChildProcess, says_how_it_ended) {
  for (const int code : {0, 1, 7, 254}) {
    expect_end(in_child_process([&] { return code; }), code, 0);
  }
  expect_end(in_child_process([]() -> int { throw Failure("no"); }), ChildEnd::kThrew, 0);
  expect_end(in_child_process([]() -> int { throw UsageError("no"); }), ChildEnd::kThrew, 0);
  for (const int signal : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT, SIGKILL}) {
    expect_end(in_child_process([&] { return std::raise(signal); }), ChildEnd::kThrew, signal);
  }
}

TEST(ChildProcess, has_no_handlers_of_this_process) {
  const auto before = std::signal(SIGSEGV, leave_quietly);
  expect_end(in_child_process([] { return std::raise(SIGSEGV); }), ChildEnd::kThrew, SIGSEGV);
  EXPECT_EQ(std::signal(SIGSEGV, before), leave_quietly) << "which stay where they are";
}

TEST(ChildProcess, prints_nothing) {
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  in_child_process([] {
    constexpr std::string_view text = "a library complains\n";
    const bool written = ::write(STDOUT_FILENO, text.data(), text.size()) > 0 &&
                         ::write(STDERR_FILENO, text.data(), text.size()) > 0;
    return written ? 0 : 1;
  });
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(ChildProcess, is_limited) {
  const auto limit_in_child = [](auto resource) {
    return in_child_process([&] {
      rlimit limit{};
      ::getrlimit(resource, &limit);
      return limit.rlim_max > 240 ? 254 : static_cast<int>(limit.rlim_max);
    });
  };
  expect_end(limit_in_child(RLIMIT_CPU), 240, 0);
  expect_end(limit_in_child(RLIMIT_CORE), 0, 0);
}

}  // namespace rupture::testing
