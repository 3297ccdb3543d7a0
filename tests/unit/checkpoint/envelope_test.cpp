// The header in front of a file: nothing that differs from what was written may pass.
#include "rupture/checkpoint/envelope.hpp"

#include "fixtures.hpp"

namespace rupture {
namespace {

using testing::bytes_of;
using testing::expect_contains;
using testing::failure_of;

std::string sealed(FileKind kind, const std::string& body) {
  return header_text(kind, bytes_of(body)) + body;
}

std::string refusal(const std::string& bytes) {
  return failure_of([&] { check_envelope(bytes_of(bytes), "x.h5"); });
}

class SmallCheckpointFile : public testing::InFolder {
 protected:
  std::string bytes() {
    write_checkpoint(file("x.h5"), testing::small_checkpoint(), IfExists::replace);
    return testing::slurp(file("x.h5"));
  }
};

TEST(Envelope, is_readable_text_of_512_bytes) {
  const std::string header = header_text(FileKind::checkpoint, bytes_of("abc"));
  EXPECT_EQ(header.size(), kHeaderSize);
  EXPECT_TRUE(header.starts_with(
      "rupture-checkpoint\nbytes 515\n"
      "sha256 ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad\n"));
  EXPECT_EQ(header.find_first_not_of('\n', header.find("sha256sum") + 9), std::string::npos);
}

TEST(Envelope, passes_what_it_sealed) {
  for (const FileKind kind : {FileKind::checkpoint, FileKind::record, FileKind::open_record}) {
    EXPECT_EQ(check_envelope(bytes_of(sealed(kind, "some body")), "x.h5"), kind);
  }
}

TEST_F(SmallCheckpointFile, with_bytes_behind_its_end_is_refused) {
  expect_contains(refusal(bytes() + '\0'), "x.h5 is damaged");
}

TEST(Envelope, refuses_foreign_files_and_says_what_they_are) {
  expect_contains(refusal("PNG or whatever"), "x.h5 is not a rupture file: expected the 512-byte");
  expect_contains(refusal(std::string(2000, 'x')), "x.h5 is not a rupture file");
  expect_contains(refusal("\x89HDF\r\n\x1a\n" + std::string(2000, '\0')),
                  "x.h5 is an HDF5 file without rupture's 512-byte header");
}

TEST(Envelope, calls_a_changed_size_in_the_header_damage_not_truncation) {
  std::string bytes = sealed(FileKind::record, "some body");
  bytes.replace(bytes.find("bytes 521"), 9, "bytes 921");
  expect_contains(refusal(bytes), "x.h5 is damaged: its bytes and the SHA-256");
}

TEST(Envelope, does_not_let_a_sealed_file_pass_as_an_open_one) {
  std::string bytes = sealed(FileKind::open_record, "some body");
  bytes[500] = ' ';
  expect_contains(refusal(bytes), "x.h5 is damaged");
}

}  // namespace
}  // namespace rupture
