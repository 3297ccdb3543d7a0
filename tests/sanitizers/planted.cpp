// Does on purpose what a sanitizer must report, or its legal counterpart, on which it must be
// silent.
//
//   planted FAULT      FAULT: data_race, no_data_race, out_of_bounds, overflow
#include <barrier>
#include <cstdio>
#include <limits>
#include <string>
#include <thread>
#include <vector>

namespace {

enum class Order { barrier, none };

/// Two threads write rows, then one of them reads both. Without the barrier that is a race.
double share_rows(Order order) {
  std::vector<double> rows(2, 1.0);
  std::barrier<> all(2);
  const auto write = [&](std::size_t row) {
    rows[row] += 1.0;
    if (order == Order::barrier) all.arrive_and_wait();
  };
  const std::jthread other(write, 1);
  write(0);
  return rows[0] + rows[1];
}

double commit(const std::string& fault) {
  if (fault == "data_race") return share_rows(Order::none);
  if (fault == "no_data_race") return share_rows(Order::barrier);
  if (fault == "out_of_bounds") return std::vector<double>(fault.size()).data()[fault.size()];
  if (fault == "overflow") return std::numeric_limits<int>::max() + static_cast<int>(fault.size());
  return 0.0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  std::printf("%g\n", commit(argv[1]));
}
