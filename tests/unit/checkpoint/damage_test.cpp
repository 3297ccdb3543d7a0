// Damage after sealing: every bit and every length of whole files, through the reader itself.
#include "fixtures.hpp"

namespace rupture {
namespace {

using testing::bytes_of;

bool is_refused(std::span<const std::byte> bytes) {
  try {
    read_bytes(bytes, "x.h5");
  } catch (const Failure&) {
    return true;
  }
  return false;
}

void expect_every_flip_refused(std::string bytes) {
  ASSERT_FALSE(is_refused(bytes_of(bytes)));
  std::size_t passed = 0;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    char& byte = bytes[bit / 8];
    const char before = byte;
    byte = static_cast<char>(byte ^ static_cast<char>(1U << bit % 8));
    passed += is_refused(bytes_of(bytes)) ? 0 : 1;
    byte = before;
  }
  EXPECT_EQ(passed, 0U) << "of " << 8 * bytes.size();
  ::testing::Test::RecordProperty("bits", std::to_string(8 * bytes.size()));
}

void expect_every_truncation_refused(const std::string& bytes) {
  std::size_t passed = 0;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    passed += is_refused(bytes_of(bytes).first(size)) ? 0 : 1;
  }
  EXPECT_EQ(passed, 0U) << "of " << bytes.size();
}

class Damage : public testing::InFolder {
 protected:
  std::string checkpoint() {
    write_checkpoint(file("x.h5"), testing::small_checkpoint(), IfExists::replace);
    return testing::slurp(file("x.h5"));
  }
  std::string record() {
    RecordWriter writer(file("r.h5"), testing::small_parameters(), {}, IfExists::replace);
    for (int n = 0; n < 3; ++n) writer.append(testing::small_sample(5, n));
    writer.finish();
    return testing::slurp(file("r.h5"));
  }
};

TEST_F(Damage, SLOW_of_any_single_bit_of_a_checkpoint_is_refused) {
  expect_every_flip_refused(checkpoint());
}

TEST_F(Damage, SLOW_of_any_single_bit_of_a_record_is_refused) {
  expect_every_flip_refused(record());
}

TEST_F(Damage, SLOW_by_truncation_of_a_checkpoint_to_any_length_is_refused) {
  expect_every_truncation_refused(checkpoint());
}

TEST_F(Damage, SLOW_by_truncation_of_a_record_to_any_length_is_refused) {
  expect_every_truncation_refused(record());
}

// Five minutes of processor time, so only on request (docs/tests.md), in the folder checkpoints/.
TEST(ShippedCheckpoint, DISABLED_with_any_single_bit_flipped_or_truncated_is_refused) {
  const std::string bytes = testing::slurp("fast-slow-fast.h5");
  expect_every_flip_refused(bytes);
  expect_every_truncation_refused(bytes);
}

}  // namespace
}  // namespace rupture
