// SPDX-FileCopyrightText: The rupture authors
// SPDX-License-Identifier: MIT

// Does on purpose what a sanitizer must report, or its legal counterpart, on which it must be
// silent.
//
//   planted FAULT      FAULT: data_race, no_data_race, out_of_bounds, overflow
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace {

enum class Order { barrier, none };

/// The pattern of Simulation::take_steps: all threads write rows, one of them reads them all and
/// writes what all then read. Without the barrier before it, that is a race.
double share_rows(Order order) {
  std::vector<double> rows(64, 1.0);
  double sum = 0.0;
  const int count = static_cast<int>(rows.size());
#pragma omp parallel num_threads(3)
  for (int step = 0; step < 100; ++step) {
#pragma omp for nowait
    for (int n = 0; n < count; ++n) rows[static_cast<std::size_t>(n)] += 1.0;
    if (order == Order::barrier) {
#pragma omp barrier
    }
#pragma omp master
    sum += rows.back();
#pragma omp barrier
#pragma omp for
    for (int n = 0; n < count; ++n) rows[static_cast<std::size_t>(n)] -= 1e-9 * sum;
  }
  return sum;
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
