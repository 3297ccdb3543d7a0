// Threads that help with the bands of a slider. The caller never waits for a helper that has not
// begun: it does that band, too. So helpers cost little where other programs hold the processors.
#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <list>
#include <thread>

namespace rupture {

using BandWork = std::function<void(int band)>;

class Helper {
 public:
  using Clock = std::chrono::steady_clock;

  explicit Helper(int band) : band_(band), thread_(&Helper::serve, this) {}
  ~Helper() { become(Now::leaving); }

  void ask(const BandWork& work, Clock::time_point now) {
    work_ = &work;
    if (now < asked_again_) {
      now_ = Now::idle;
    } else {
      become(Now::asked);
    }
  }

  /// Returns when the band of the last ask is done. A helper for which the caller waits four times
  /// as long as it has worked itself has lost its processor, and is not asked again for 20 times as
  /// long. (One that has begun late costs less, and would begin late again after a rest.)
  void complete(Clock::time_point asked) {
    Now found = Now::asked;
    if (now_.compare_exchange_strong(found, Now::idle) || found == Now::idle) {
      (*work_)(band_);
    } else if (found == Now::busy) {
      const auto begin = Clock::now();
      wait_while(Now::busy);
      const auto end = Clock::now();
      if (end - begin > 4 * (begin - asked)) asked_again_ = end + 20 * (end - begin);
    }
  }

 private:
  enum class Now : int { idle, asked, busy, done, leaving };

  void become(Now now) {
    now_ = now;
    now_.notify_one();
  }

  /// A short wait keeps the processor, a long one leaves it to others.
  void wait_while(Now now) const {
    const auto end = Clock::now() + std::chrono::microseconds(50);
    while (now_ == now) {
      if (Clock::now() > end) now_.wait(now);
    }
  }

  void serve() {
    for (Now now = Now::idle; now != Now::leaving; now = now_) {
      if (now == Now::asked && now_.compare_exchange_strong(now, Now::busy)) {
        (*work_)(band_);
        become(now = Now::done);
      }
      wait_while(now);
    }
  }

  const int band_;
  const BandWork* work_ = nullptr;
  Clock::time_point asked_again_;
  std::atomic<Now> now_ = Now::idle;
  std::jthread thread_;  // last: it uses the others
};

class Helpers {
 public:
  explicit Helpers(int bands) {
    for (int band = 1; band < bands; ++band) all_.emplace_back(band);
  }

  /// Does the work for every band, and on this thread whatever is to be done in the meantime.
  void share(
      const BandWork& work, const std::function<void()>& meanwhile = [] {}) {
    const auto begin = all_.empty() ? Helper::Clock::time_point() : Helper::Clock::now();
    for (Helper& helper : all_) helper.ask(work, begin);
    std::exception_ptr failure;  // such as std::bad_alloc; helpers must not outlive the work
    try {
      work(0);
      meanwhile();
    } catch (...) {
      failure = std::current_exception();
    }
    for (Helper& helper : all_) helper.complete(begin);
    if (failure) std::rethrow_exception(failure);
  }

 private:
  std::list<Helper> all_;
};

}  // namespace rupture
