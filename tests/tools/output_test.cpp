// Files that the programs write: their names, sums and bytes, and what stays of those that were
// there. The refusals are in tables/bad_output.txt.
#include <hdf5.h>

#include "tool_test.hpp"

namespace rupture::testing {
namespace {

using Output = ToolTest;

TEST_F(Output, of_the_same_command_is_the_same) {
  output_of("load --config small.ini -o a.h5 --until 4e-4 --record r.h5 -f");
  const Files first = files();
  EXPECT_EQ(first.size(), 3U);  // with small.ini
  output_of("load --config small.ini -o a.h5 --until 4e-4 --record r.h5 -f");
  EXPECT_EQ(files(), first);
}

TEST_F(Output, names_checkpoints_on_the_way) {
  fs::create_directory(path("sub"));
  output_of("load --config small.ini -o sub/noext --until 1e-4 --checkpoint-at 1e-4 2e-5 -q");
  const Files all = files();
  EXPECT_EQ(all.size(), 5U);  // small.ini, sub/ and three checkpoints
  for (const char* name : {"sub/noext", "sub/noext-t0.000020000", "sub/noext-t0.000100000"}) {
    EXPECT_TRUE(all.contains(name)) << name;
  }
}

TEST_F(Output, is_named_with_its_checksum_and_has_a_sum_on_request_only) {
  const std::vector<std::string> commands = {
      "load --config small.ini -o a.h5 --until 1e-4 --checkpoint-at 5e-5 --record r.h5",
      "restart a.h5 -o b.h5 --for 2e-5 --checkpoint-at 1.1e-4 --record s.h5",
      "prepare --tau-bar 0.1 -o c.h5", "modify-phi a.h5 -o d.h5"};
  std::string said;
  for (const auto& command : commands) said += output_of(command);
  const Files without = files();
  for (const auto& command : commands) output_of(command + " --sum --force");
  for (const auto& [name, bytes] : without) {
    EXPECT_FALSE(name.ends_with(".sum")) << name;
    if (!name.ends_with(".h5")) continue;
    EXPECT_EQ(read(name + ".sum"), sum_line(name));
    const bool on_the_way = name.find("-t0") != std::string::npos;
    const std::string line = "wrote " + name + "  " + sum_line(name).substr(0, 79) + "\n";
    EXPECT_EQ(said.find(line) != std::string::npos, !on_the_way) << line;
  }
}

TEST_F(Output, has_never_the_sum_of_a_file_that_it_replaced) {
  output_of("load --config small.ini -o a.h5 --record r.h5 --sum");
  const std::string sum = read("a.h5.sum");
  output_of("load --config small.ini -o a.h5 --record r.h5 --force");
  EXPECT_EQ(read("a.h5.sum"), sum) << "of the same content";
  output_of("load --config small.ini -o a.h5 --record r.h5 --until 1e-5 --force");
  EXPECT_FALSE(fs::exists(path("a.h5.sum")));
  EXPECT_FALSE(fs::exists(path("r.h5.sum")));
}

TEST_F(Output, replaces_files_when_forced) {
  write("a-t0.000050000.h5", "precious");
  const std::string command = "load --config small.ini -o a.h5 --until 1e-4 --checkpoint-at 5e-5";
  expect_refusal(command, kFailed, "a-t0.000050000.h5 exists; give --force to replace it");
  output_of(command + " --record r.h5 --force");
  EXPECT_DOUBLE_EQ(json_of("analyze stress a-t0.000050000.h5 --json")["time"], 5e-5);
  const std::string before = checksum_of("a.h5");
  output_of("modify-phi a-t0.000050000.h5 -o a.h5 -f");
  EXPECT_NE(checksum_of("a.h5"), before);
  output_of("restart a-t0.000050000.h5 -o a.h5 --for 5e-5 --record r.h5 -f");
  EXPECT_EQ(checksum_of("a.h5"), before);
}

TEST_F(Output, replaces_a_dangling_link_and_never_follows_it) {
  fs::create_symlink("elsewhere.h5", path("link.h5"));
  output_of("load --config small.ini -o link.h5 --force");
  EXPECT_FALSE(fs::exists(path("elsewhere.h5")));
  EXPECT_FALSE(fs::is_symlink(path("link.h5")));
}

TEST_F(Output, on_a_full_disk_leaves_a_readable_part_beside_the_old_files) {
  output_of("load --config small.ini -o old.h5 --record old-r.h5 -q");
  const Files before = files();
  const Outcome outcome =
      run("load --config small.ini --until 4e-4 -o old.h5 --record old-r.h5 --record-every 2e-7 "
          "--force",
          {.largest_file = 250000});
  EXPECT_EQ(outcome.exit_code, kFailed);
  expect_one_sentence(outcome.err, "load", "old-r.h5");
  for (const auto& [name, bytes] : before) EXPECT_TRUE(files().at(name) == bytes) << name;
  output_of("analyze loading old-r.h5.part --json");
}

TEST_F(Output, is_not_lost_with_standard_output) {
  const Outcome outcome =
      run("load --config small.ini -o b.h5 --until 1e-4", {.standard_output = "/dev/full"});
  EXPECT_EQ(outcome.exit_code, kFailed);
  expect_one_sentence(outcome.err, "load", "cannot write to standard output");
  EXPECT_DOUBLE_EQ(json_of("analyze stress b.h5 --json")["time"], 1e-4);
}

TEST_F(Output, of_seal_never_replaces_the_original) {
  output_of("load --config small.ini -o a.h5");
  fs::copy_file(path("a.h5"), path("e.h5"));
  const hid_t file = H5Fopen(path("e.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  H5Ldelete(file, "/run", H5P_DEFAULT);
  H5Fclose(file);
  expect_refusal("seal e.h5 -o a.h5 --original a.h5 --force", kUsage,
                 "a.h5 is the input, which is never changed: give another output");
  output_of("seal e.h5 -o b.h5 --original a.h5 -q");
  H5Fclose(H5Fcreate(path("e.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  expect_refusal("seal e.h5 -o c.h5", kFailed,
                 "e.h5: format is missing; expected text, as in every file that one of rupture's "
                 "programs wrote");
}

TEST_F(Output, of_prepare_has_the_prestress) {
  const std::string prepare = "prepare --config small.ini --set driving.V=0 ";
  output_of(prepare + "-o a.h5 --tau-bar 0.2 --sigma-bar 0.1 --no-trigger");
  const Json stress = json_of("analyze stress a.h5 --json");
  const std::vector<double> p = stress["p"], tau = stress["tau"],
                            sigma_bar = json_of("analyze phi a.h5 --json")["sigma_bar"];
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_DOUBLE_EQ(p[i], 1920.0 / 9);
    EXPECT_NEAR(tau[i] / p[i], i < 2 ? 0.239 : 0.216, 1e-9);
    EXPECT_NEAR(sigma_bar[i], 0.1, 1e-4);
  }
  EXPECT_NEAR(stress["F_T"], (2 * 0.239 + 7 * 0.216) * 1920 / 9, 1e-6);
  const Json springs = json_of(prepare +
                               "-o b.h5 --tau-bar 0.8 --set junctions.law=simplified "
                               "--json -q");
  EXPECT_LT(springs["error"], 1e-12);
}

// Pulled a little, then let go: the junctions give back what they took.
TEST_F(Output, accounts_for_damping_and_for_the_junctions_apart) {
  output_of("load --config small.ini -o a.h5");
  output_of("restart a.h5 -o b.h5 --for 5e-5");
  const std::string out = output_of("restart b.h5 -o c.h5 --for 5e-5 --set driving.V=-1");
  const auto number_behind = [&](const std::string& words) {
    const auto at = out.find(words);
    EXPECT_NE(at, std::string::npos) << out;
    return at == std::string::npos ? 0.0 : std::stod(out.substr(at + words.size()));
  };
  EXPECT_GT(number_behind(" + taken by damping "), 0.0);
  EXPECT_NEAR(number_behind("supplied "),
              number_behind(" = stored ") + number_behind(" + taken by damping ") +
                  number_behind(" + work against junctions "),
              1e-6 * std::abs(number_behind("supplied ")));
}

}  // namespace
}  // namespace rupture::testing
