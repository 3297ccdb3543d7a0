// Files on disk: what stands in them. tests/tools/files.txt has refusals.
#include "rupture/checkpoint/file.hpp"

#include "fixtures.hpp"

namespace rupture::testing {

class File : public InFolder {};

TEST_F(File, has_a_header_of_512_bytes_that_people_can_read) {
  const std::string header = header_text(FileKind::checkpoint, bytes_of("abc"));
  EXPECT_EQ(header.size(), kHeaderSize);
  EXPECT_TRUE(header.starts_with(
      "rupture-checkpoint\nbytes 515\n"
      "sha256 ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad\n"));
  EXPECT_EQ(header.find_first_not_of('\n', header.find("sha256sum") + 9), std::string::npos);
}

TEST_F(File, whose_data_do_not_fill_their_shape_is_not_written) {
  const Content content = {{"/state/a", Dataset{"m", DataType::uint8, {3}, {std::byte{1}}}}};
  const auto write_it = [&] {
    write_content(file("x.h5"), FileKind::checkpoint, content, IfExists::refuse);
  };
  expect_contains(message_of<Failure>(write_it), "/state/a has 1 bytes, but its shape [3] needs 3");
  EXPECT_TRUE(names().empty());
}

// --- damage: every bit and every length of whole files, through the reader itself

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

class Damage : public InFolder {};

TEST_F(Damage, SLOW_of_a_checkpoint_at_any_bit_or_length_is_refused) {
  write_checkpoint(file("x.h5"), small_checkpoint(), IfExists::replace);
  expect_all_damage_refused(slurp(file("x.h5")));
}

}  // namespace rupture::testing
