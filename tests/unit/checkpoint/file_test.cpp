// Files on disk: what is refused, what is left behind, and what is left alone.
#include "rupture/checkpoint/file.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "../../../src/checkpoint/hdf5_image.hpp"
#include "fixtures.hpp"
#include "rupture/checkpoint/checksum.hpp"
#include "rupture/version.hpp"

namespace rupture {
namespace {

namespace fs = std::filesystem;

using testing::expect_contains;
using testing::failure_of;
using testing::slurp;
using testing::small_checkpoint;
using testing::spill;

// Limits the size of files while it lives [bytes].
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t size) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{size, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  FileSizeLimit(FileSizeLimit&&) = delete;
  FileSizeLimit& operator=(FileSizeLimit&&) = delete;
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_{};
};

// Permissions mean nothing to root: becomes nobody while it lives.
class Unprivileged {
 public:
  Unprivileged() {
    if (geteuid() == 0) became_nobody_ = seteuid(65534) == 0;
  }
  Unprivileged(const Unprivileged&) = delete;
  Unprivileged& operator=(const Unprivileged&) = delete;
  Unprivileged(Unprivileged&&) = delete;
  Unprivileged& operator=(Unprivileged&&) = delete;
  ~Unprivileged() {
    if (became_nobody_ && seteuid(0) != 0) std::abort();
  }

 private:
  bool became_nobody_ = false;
};

class File : public testing::InFolder {
 protected:
  std::string write(const fs::path& path, IfExists if_exists = IfExists::refuse) {
    return write_checkpoint(path, small_checkpoint(), if_exists);
  }
  std::string write_with_sum(const fs::path& path) {
    return write_checkpoint(path, small_checkpoint(), IfExists::refuse, SumFile::write);
  }
  std::string reading(const fs::path& path) {
    return failure_of([&] { read_checkpoint(path); });
  }
  std::string quoted(const char* name) { return file(name).string(); }

  // A file with any root attributes, sealed as if it were ours.
  void write_sealed(const fs::path& path, FileKind kind, const hdf5::RootAttributes& attributes,
                    const Content& content) {
    const auto image = hdf5::make_image(attributes, content);
    const std::string bytes(reinterpret_cast<const char*>(image.data()), image.size());
    const std::string body = bytes.substr(kHeaderSize);
    spill(path, header_text(kind, testing::bytes_of(body)) + body);
  }
};

TEST_F(File, missing_is_said_to_be_missing) {
  EXPECT_EQ(reading(file("no.h5")),
            quoted("no.h5") + " does not exist; give the path of a checkpoint or record");
  EXPECT_EQ(reading(file("no/x.h5")),
            quoted("no/x.h5") + " does not exist; give the path of a checkpoint or record");
}

TEST_F(File, that_is_a_folder_or_device_is_refused) {
  EXPECT_EQ(reading(folder_),
            folder_.string() + " is a folder; give the path of a checkpoint or record");
  EXPECT_EQ(reading("/dev/null"),
            "/dev/null is not a regular file; give the path of a checkpoint or record");
}

TEST_F(File, empty_is_said_to_be_empty) {
  spill(file("x.h5"), "");
  EXPECT_EQ(reading(file("x.h5")), quoted("x.h5") + " is empty; expected a checkpoint or record");
}

TEST_F(File, without_read_permission_is_refused_with_the_reason) {
  write(file("x.h5"));
  chmod(folder_.c_str(), 0755);
  chmod(file("x.h5").c_str(), 0);
  const Unprivileged nobody;
  expect_contains(reading(file("x.h5")),
                  "could not read " + quoted("x.h5") + ": Permission denied");
}

TEST_F(File, SLOW_foreign_truncated_or_damaged_is_refused) {
  spill(file("x.h5"), "hello");
  expect_contains(reading(file("x.h5")), "x.h5 is not a rupture file");
  write(file("x.h5"), IfExists::replace);
  const std::string bytes = slurp(file("x.h5"));
  spill(file("x.h5"), bytes.substr(kHeaderSize));
  expect_contains(reading(file("x.h5")), "x.h5 is an HDF5 file without rupture's 512-byte header");
  spill(file("x.h5"), bytes.substr(0, bytes.size() / 2));
  expect_contains(reading(file("x.h5")), "x.h5 is truncated");
  for (std::size_t at = 0; at < bytes.size(); at += 97) {
    std::string damaged = bytes;
    damaged[at] = static_cast<char>(damaged[at] ^ 4);
    spill(file("x.h5"), damaged);
    EXPECT_NE(reading(file("x.h5")), "(no failure)") << at;
    EXPECT_NE(failure_of([&] { verify_file(file("x.h5")); }), "(no failure)") << at;
  }
}

TEST_F(File, of_a_newer_schema_is_refused_before_its_datasets_are_read) {
  const auto refusal_with = [&](const Content& content) {
    write_sealed(file("x.h5"), FileKind::checkpoint, {"rupture-checkpoint", kSchemaVersion + 1, ""},
                 content);
    return reading(file("x.h5"));
  };
  const std::string newer =
      fmt::format(" (schema {}); this is rupture {}, which reads up to schema {}: use ",
                  kSchemaVersion + 1, version, kSchemaVersion);
  const Content unknown = {{"/state/u_x", make_scalar(std::nan(""), "m")}};
  EXPECT_EQ(refusal_with(unknown),
            quoted("x.h5") + ": written by a newer rupture" + newer + "a newer rupture");
  Content named = unknown;
  named["/provenance/0000/version"] = make_text("0.8.0");
  named["/provenance/0001/version"] = make_text("0.9.0");
  named["/provenance/0001/news"] = make_text("of schema 3");
  EXPECT_EQ(refusal_with(named),
            quoted("x.h5") + ": written by rupture 0.9.0" + newer + "rupture 0.9.0 or newer");
}

TEST_F(File, whose_header_and_attributes_disagree_is_refused) {
  write_sealed(file("x.h5"), FileKind::checkpoint, {"rupture-record", 1, ""}, {});
  expect_contains(reading(file("x.h5")),
                  "its header says rupture-checkpoint, but its attributes say rupture-record");
}

TEST_F(File, whose_content_checksum_is_wrong_is_refused) {
  const Content content = parameters_content(testing::small_parameters());
  write_sealed(file("x.h5"), FileKind::checkpoint, {"rupture-checkpoint", 1, std::string(64, '0')},
               content);
  expect_contains(reading(file("x.h5")),
                  "its content has the checksum " + content_checksum(content) + ", but 0000");
}

// A parameter of another law with a value of its own counted until schema 2.
TEST_F(File, is_verified_by_the_rule_of_its_schema) {
  Parameters parameters = testing::small_parameters();
  parameters.v_slow = 1.0;
  const Content content = parameters_content(parameters);
  const std::string early = content_checksum_of_schema_2(content);
  ASSERT_NE(early, content_checksum(content));
  const auto write_as = [&](std::int64_t schema, const std::string& checksum) {
    write_sealed(file("x.h5"), FileKind::checkpoint, {"rupture-checkpoint", schema, checksum},
                 content);
    return failure_of([&] {
      const ContentFile read = read_file(file("x.h5"));
      EXPECT_EQ(read.stored_checksum, checksum);
      EXPECT_EQ(read.checksum, content_checksum(parameters_content(testing::small_parameters())));
    });
  };
  for (const std::int64_t schema : {1, 2}) {
    EXPECT_EQ(write_as(schema, early), "(no failure)");
    expect_contains(write_as(schema, content_checksum(content)), "its content has the checksum");
  }
  EXPECT_EQ(write_as(3, content_checksum(content)), "(no failure)");
  expect_contains(write_as(3, early), "its content has the checksum");
}

// Its checksum is that of the rule of the newer build, in which the parameter does not count.
TEST_F(File, with_a_parameter_of_a_newer_build_is_not_taken_for_damaged) {
  Content content = parameters_content(testing::small_parameters());
  const std::string checksum = content_checksum(content);
  content["/parameters/junctions/new"] = make_scalar(1.0, "1");
  write_sealed(file("x.h5"), FileKind::checkpoint, {"rupture-checkpoint", kSchemaVersion, checksum},
               content);
  expect_contains(reading(file("x.h5")),
                  "/parameters/junctions/new is no parameter of this build: use a newer rupture");
}

TEST_F(File, with_nan_is_refused_on_reading) {
  Content content = parameters_content(testing::small_parameters());
  content["/parameters/slider/L"] = make_scalar(std::nan(""), "m");
  write_sealed(file("x.h5"), FileKind::checkpoint,
               {"rupture-checkpoint", 1, content_checksum(content)}, content);
  expect_contains(reading(file("x.h5")), "x.h5: /parameters/slider/L holds nan");
}

TEST_F(File, that_exists_is_only_replaced_on_request) {
  write(file("x.h5"));
  EXPECT_EQ(failure_of([&] { write(file("x.h5")); }),
            quoted("x.h5") + " exists; give --force to replace it");
  EXPECT_NO_THROW(write(file("x.h5"), IfExists::replace));
  EXPECT_EQ(names(), std::vector<std::string>{"x.h5"});
}

TEST_F(File, cannot_be_written_where_there_is_no_room_for_it) {
  fs::create_directory(file("d"));
  EXPECT_EQ(failure_of([&] { write(file("d"), IfExists::replace); }),
            quoted("d") + " is a folder; give the path of a file to write");
  expect_contains(failure_of([&] { write(file("no/x.h5")); }),
                  "could not write " + quoted("no/x.h5") + ": its folder " + quoted("no") +
                      ": No such file or directory");
  EXPECT_EQ(failure_of([] { check_output("/dev/null", IfExists::replace); }),
            "/dev/null is not a regular file; give another path");
  expect_contains(failure_of([&] { write(file(std::string(250, 'n'))); }), "File name too long");
}

TEST_F(File, in_a_read_only_folder_is_refused_with_the_reason) {
  chmod(folder_.c_str(), 0555);
  const Unprivileged nobody;
  expect_contains(failure_of([&] { check_output(file("x.h5"), IfExists::refuse); }),
                  "could not write " + quoted("x.h5") + ": its folder " + folder_.string() +
                      ": Permission denied");
}

TEST_F(File, that_does_not_fit_on_the_disk_leaves_the_old_one_and_no_temporary) {
  write_with_sum(file("x.h5"));
  const std::string before = slurp(file("x.h5"));
  Checkpoint other = small_checkpoint();
  other.state.step = 1;
  {
    const FileSizeLimit limit(1000);  // sends SIGXFSZ, which would kill the process
    EXPECT_EQ(failure_of([&] { write_checkpoint(file("x.h5"), other, IfExists::replace); }),
              "could not write " + quoted("x.h5") + ": File too large");
  }
  EXPECT_EQ(slurp(file("x.h5")), before);
  EXPECT_EQ(names(), (std::vector<std::string>{"x.h5", "x.h5.sum"}));
}

TEST_F(File, whose_data_do_not_fill_their_shape_is_not_written) {
  const Content content = {{"/state/a", Dataset{"m", DataType::uint8, {3}, {std::byte{1}}}}};
  const auto write_it = [&] {
    write_content(file("x.h5"), FileKind::checkpoint, content, IfExists::refuse);
  };
  expect_contains(failure_of(write_it), "/state/a has 1 bytes, but its shape [3] needs 3");
  EXPECT_TRUE(names().empty());
}

TEST_F(File, has_its_checksum_beside_it_on_request) {
  const std::string checksum = write_with_sum(file("x.h5"));
  EXPECT_EQ(slurp(file("x.h5.sum")), "content-sha256 " + checksum + "  x.h5\n");
}

TEST_F(File, with_equal_content_leaves_the_sum_untouched) {
  write_with_sum(file("x.h5"));
  const auto long_ago = fs::last_write_time(file("x.h5.sum")) - std::chrono::hours(1);
  fs::last_write_time(file("x.h5.sum"), long_ago);
  Checkpoint retold = small_checkpoint();
  retold.provenance.pop_back();
  for (const SumFile sum : {SumFile::omit, SumFile::write}) {
    write_checkpoint(file("x.h5"), retold, IfExists::replace, sum);
    EXPECT_EQ(fs::last_write_time(file("x.h5.sum")), long_ago);
  }
  retold.state.step += 1;
  write_checkpoint(file("x.h5"), retold, IfExists::replace, SumFile::write);
  EXPECT_NE(fs::last_write_time(file("x.h5.sum")), long_ago);
}

TEST_F(File, with_other_content_removes_the_sum_that_is_not_asked_for) {
  write_with_sum(file("x.h5"));
  Checkpoint other = small_checkpoint();
  other.state.step += 1;
  write_checkpoint(file("x.h5"), other, IfExists::replace);
  EXPECT_EQ(names(), std::vector<std::string>{"x.h5"});
}

TEST_F(File, gets_a_sum_in_the_form_of_today) {
  const std::string checksum = write(file("x.h5"));
  spill(file("x.h5.sum"), checksum + "  x.h5\n");
  restore_sum(file("x.h5"));
  EXPECT_EQ(slurp(file("x.h5.sum")), "content-sha256 " + checksum + "  x.h5\n");
}

}  // namespace
}  // namespace rupture
