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

void expect_all_damage_refused(std::string bytes) {
  ASSERT_FALSE(is_refused(bytes_of(bytes)));
  std::size_t passed = 0;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    char& byte = bytes[bit / 8];
    const char before = byte;
    byte = static_cast<char>(byte ^ static_cast<char>(1U << bit % 8));
    passed += is_refused(bytes_of(bytes)) ? 0 : 1;
    byte = before;
  }
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    passed += is_refused(bytes_of(bytes).first(size)) ? 0 : 1;
  }
  EXPECT_EQ(passed, 0U) << "of " << 9 * bytes.size();
}

class Damage : public testing::InFolder {};

TEST_F(Damage, SLOW_of_a_checkpoint_at_any_bit_or_length_is_refused) {
  write_checkpoint(file("x.h5"), testing::small_checkpoint(), IfExists::replace);
  expect_all_damage_refused(testing::slurp(file("x.h5")));
}

TEST_F(Damage, SLOW_of_a_record_at_any_bit_or_length_is_refused) {
  RecordWriter writer(file("r.h5"), testing::small_parameters(), {}, IfExists::replace);
  for (int n = 0; n < 3; ++n) writer.append(testing::small_sample(5, n));
  writer.finish();
  expect_all_damage_refused(testing::slurp(file("r.h5")));
}

// Five minutes of processor time, so only on request (docs/tests.md), in the folder checkpoints/.
TEST(ShippedCheckpoint, DISABLED_with_any_single_bit_flipped_or_truncated_is_refused) {
  expect_all_damage_refused(testing::slurp("fast-slow-fast.h5"));
}

}  // namespace
}  // namespace rupture
