#include "rupture/checkpoint/provenance.hpp"

#include <gtest/gtest.h>

#include "rupture/version.hpp"

namespace rupture::testing {

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
