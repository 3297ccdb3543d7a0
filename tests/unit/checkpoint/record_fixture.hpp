// Shared by the tests of records: small ones, of which every number is known.
#pragma once

#include <string>
#include <vector>

#include "fixtures.hpp"

namespace rupture::testing {

class RecordFile : public InFolder {
 protected:
  static constexpr std::size_t kNx = 5;

  RecordWriter writer(const char* name, std::size_t flush_every = 256,
                      IfExists if_exists = IfExists::refuse) {
    return {file(name), small_parameters(), small_checkpoint().provenance, if_exists,
            {},         flush_every};
  }

  static void append(RecordWriter& record, int from, int to) {
    for (int n = from; n < to; ++n) {
      record.append(small_sample(kNx, n));
      if (n % 4 == 0) record.append(std::vector<rupture::Rupture>{{100 * n, 0.001 * n, n % 5}});
    }
  }

  static void expect_samples(const Record& record, int count) {
    ASSERT_EQ(record.time.size(), static_cast<std::size_t>(count));
    ASSERT_EQ(record.u_x.rows(), count);
    for (int n = 0; n < count; ++n) {
      const Sample sample = small_sample(kNx, n);
      const auto at = static_cast<std::size_t>(n);
      EXPECT_EQ(record.time[at], sample.time);
      EXPECT_EQ(record.step[at], sample.step);
      EXPECT_EQ(record.F_T[at], sample.F_T);
      EXPECT_EQ(record.x_drive[at], sample.x_drive);
      for (std::size_t i = 0; i < kNx; ++i) {
        const auto column = static_cast<Eigen::Index>(i);
        EXPECT_EQ(record.pinned(n, column), sample.pinned[i]);
        EXPECT_EQ(record.p(n, column), sample.p[i]);
        EXPECT_EQ(record.tau(n, column), sample.tau[i]);
        EXPECT_EQ(record.u_x(n, column), sample.u_x[i]);
      }
    }
  }
};

}  // namespace rupture::testing
