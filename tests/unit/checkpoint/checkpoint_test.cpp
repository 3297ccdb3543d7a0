#include "rupture/checkpoint/checkpoint.hpp"

#include <fmt/format.h>

#include "fixtures.hpp"
#include "rupture/version.hpp"

namespace rupture::testing {

class CheckpointFile : public InFolder {
 protected:
  std::string write(const Checkpoint& checkpoint) {
    return write_checkpoint(file("x.h5"), checkpoint, IfExists::replace);
  }
};

// The bound that docs/schema.md states, and reading a chain whose texts are all the same.
TEST_F(CheckpointFile, grows_by_little_with_each_step_of_its_provenance) {
  Checkpoint checkpoint = small_checkpoint();
  write(checkpoint);
  const auto before = fs::file_size(file("x.h5"));
  const std::string text(40, 'x');
  checkpoint.provenance.resize(102, {text, text, text, text, text, text, text});
  write(checkpoint);
  EXPECT_EQ(read_checkpoint(file("x.h5")).provenance, checkpoint.provenance);
  for (int i = 2; i < 102; ++i) {
    auto& step = checkpoint.provenance[static_cast<std::size_t>(i)];
    step.command_line = step.rebuild = fmt::format("restart --until {}", i);
    step.parent_checksum = fmt::format("{:064}", i);
  }
  write(checkpoint);
  EXPECT_LT(fs::file_size(file("x.h5")), before + 100 * (1100 + 2 * 20));
  EXPECT_EQ(read_checkpoint(file("x.h5")).provenance, checkpoint.provenance);
}

TEST_F(CheckpointFile, of_a_run_remembers_what_the_run_has_seen) {
  Checkpoint written = small_checkpoint();
  const std::string without = write(written);
  EXPECT_FALSE(read_checkpoint(file("x.h5")).run);
  written.run = {.id = "abc",
                 .first_step = 3,
                 .last_break = 70,
                 .ruptures = 5,
                 .leading_edge_ruptured = true,
                 .event = {{{}, 0.25, 0.5, {}, {}}, 0.5},
                 .spanned = true,
                 .early = {.quiet_steps = 500, .spanned = true, .arrived_below = 0.25}};
  EXPECT_EQ(write(written), without) << "it is no part of the content that is checksummed";
  EXPECT_EQ(read_checkpoint(file("x.h5")).run, written.run);
  for (const EarlyEnd& early : {EarlyEnd{},
                                {.spanned = true},
                                {.rupture_of = 4},
                                {.quiet_time = 0.02, .condition = "t", .condition_every = 2}}) {
    written.run->early = early;
    write(written);
    EXPECT_EQ(read_checkpoint(file("x.h5")).run, written.run);
  }
}

// --- provenance

TEST(Provenance, quotes_arguments_as_a_shell_needs_them) {
  EXPECT_EQ(shell_line({"load", "-o", "a/b.h5", "--set=driving.V=0"}),
            "load -o a/b.h5 --set=driving.V=0");
  EXPECT_EQ(shell_line({"x", "", "a b", "it's", "$HOME", "*", "a\nb", "~", "\\"}),
            "x '' 'a b' 'it'\\''s' '$HOME' '*' 'a\nb' '~' '\\'");
}

TEST(Provenance, of_this_build_names_tool_version_commit_and_compiler) {
  const ProvenanceEntry entry =
      make_provenance("load", {"load", "--until", "1 s"}, "abc", "load --until 1");
  EXPECT_EQ(entry.tool, "load");
  EXPECT_EQ(entry.version, version);
  EXPECT_EQ(entry.commit, commit);
  EXPECT_EQ(entry.command_line, "load --until '1 s'");
  EXPECT_EQ(entry.parent_checksum, "abc");
  EXPECT_EQ(entry.rebuild, "load --until 1");
  EXPECT_TRUE(entry.compiler.starts_with("gcc ") || entry.compiler.starts_with("clang "));
}

}  // namespace rupture::testing
