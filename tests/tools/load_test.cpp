// load: equilibrium, driving, configuration, checkpoints on the way.
#include <cmath>
#include <numeric>

#include "tool_test.hpp"

namespace rupture::testing {
namespace {

using Load = ToolTest;

TEST_F(Load, equilibrium_bears_the_normal_load_at_rest) {
  output_of("load --config small.ini -o a.h5");
  const Json stress = json_of("analyze stress a.h5 --json");
  const std::vector<double> p = stress["p"], tau = stress["tau"], x = stress["x"];
  EXPECT_EQ(stress["time"], 0.0);
  EXPECT_EQ(stress["F_N"], 1920.0);
  EXPECT_NEAR(stress["F_T"], 0.0, 1e-9);
  ASSERT_EQ(p.size(), 9U);
  ASSERT_EQ(tau.size(), 9U);
  ASSERT_EQ(x.size(), 9U);
  EXPECT_NEAR(x.back(), 0.14, 1e-15);
  EXPECT_NEAR(std::accumulate(p.begin(), p.end(), 0.0), 1920.0, 1e-9 * 1920.0);
  EXPECT_NEAR(std::accumulate(tau.begin(), tau.end(), 0.0), 0.0, 1e-9 * 1920.0);
}

TEST_F(Load, writes_a_checkpoint_and_nothing_else) {
  output_of("load --config small.ini -o a.h5");
  EXPECT_EQ(files().size(), 2U);  // with small.ini
}

TEST_F(Load, same_command_gives_the_same_bytes) {
  output_of("load --config small.ini -o a.h5 --until 4e-4 --record r.h5 -f");
  const Files first = files();
  output_of("load --config small.ini -o a.h5 --until 4e-4 --record r.h5 -f");
  EXPECT_EQ(files(), first);
}

TEST_F(Load, threads_change_no_bit) {
  output_of("load --config small.ini -o a.h5 --until 4e-4 --record a-record.h5");
  output_of("load --config small.ini -o b.h5 --until 4e-4 --record b-record.h5 --threads 3");
  EXPECT_EQ(checksum_of("a.h5"), checksum_of("b.h5"));
  EXPECT_EQ(checksum_of("a-record.h5"), checksum_of("b-record.h5"));
}

TEST_F(Load, drives_until_the_given_time) {
  const std::string out = output_of("load --config small.ini -o a.h5 --until 1e-4");
  EXPECT_NE(out.find("t = 0.0001 s (end of the run), 500 steps"), std::string::npos) << out;
  EXPECT_NE(out.find("relative error"), std::string::npos) << out;
  const Json stress = json_of("analyze stress a.h5 --json");
  EXPECT_DOUBLE_EQ(stress["time"], 1e-4);
  EXPECT_GT(stress["F_T"], 100.0);
}

TEST_F(Load, configuration_holds_sections_comments_and_options) {
  write("run.ini",
        "# a comment\nuntil = 1e-4   # five hundred steps\noutput = a.h5\nquiet =\n\n"
        "[slider]\nNx = 9\nNz = 5\nH=0.07\n[driving]\nh = 0.0175\nV = 1\n");
  EXPECT_EQ(output_of("load --config run.ini"), "");
  output_of("load --config small.ini -o b.h5 --until 1e-4");
  EXPECT_EQ(checksum_of("a.h5"), checksum_of("b.h5"));
}

TEST_F(Load, command_line_overrides_the_configuration) {
  write("run.ini",
        "until = 1e-3\nslider.Nx = 9\nslider.Nz = 5\nslider.H = 0.07\ndriving.h = 0.0175\n"
        "driving.V = 5\n");
  output_of("load --config run.ini --set driving.V=1 --until 1e-4 -o a.h5");
  output_of("load --config small.ini -o b.h5 --until 1e-4");
  EXPECT_EQ(checksum_of("a.h5"), checksum_of("b.h5"));
}

TEST_F(Load, numbers_with_units_give_what_plain_numbers_give) {
  output_of(
      "load --config small.ini -o a.h5 --until 4e-4 --checkpoint-at 1e-4 2e-4 --record a-r.h5 "
      "--record-every 2e-5 --set numerics.dt=1e-7");
  write("run.ini",
        "\xEF\xBB\xBFuntil = 0.4 ms   # with a unit\n[slider]\nNx = 9\nNz = 5\nH = 70 "
        "mm\n[driving]\nh = 17.5mm\n"
        "V = 1\n");
  output_of(
      "load --config run.ini -o b.h5 --checkpoint-at 100us 0.2ms --record b-r.h5 "
      "--record-every 20us --set numerics.dt=0.1us");
  for (const std::string rest : {".h5", "-r.h5", "-t0.000100000.h5", "-t0.000200000.h5"}) {
    EXPECT_EQ(checksum_of("a" + rest), checksum_of("b" + rest)) << rest;
  }
  output_of("prepare --tau-bar 0.3 -o c.h5 --x-trigger 0.03");
  output_of("prepare --tau-bar 0.3 -o d.h5 --x-trigger 30mm");
  EXPECT_EQ(checksum_of("c.h5"), checksum_of("d.h5"));
}

TEST_F(Load, is_made_again_from_a_command_with_units) {
  const Outcome outcome = run_words({"load", "--config", "small.ini", "-o", "a.h5", "--until",
                                     "0.1 ms", "--set", "numerics.dt=0.1 us"});
  ASSERT_EQ(outcome.exit_code, kDone) << outcome.err;
  const std::string rebuild = json_of("analyze show a.h5 --json")["provenance"][0]["rebuild"];
  EXPECT_NE(rebuild.find("--set numerics.dt=1e-07 --until 0.0001"), std::string::npos) << rebuild;
  output_of(rebuild + " -o b.h5");
  EXPECT_EQ(checksum_of("a.h5"), checksum_of("b.h5"));
}

TEST_F(Load, seed_is_short_for_the_parameter) {
  output_of("load --config small.ini -o a.h5 --until 4e-4 --seed 7");
  output_of("load --config small.ini -o b.h5 --until 4e-4 --set numerics.seed=7");
  EXPECT_EQ(checksum_of("a.h5"), checksum_of("b.h5"));
  EXPECT_EQ(json_of("analyze show a.h5 --json")["parameters"]["numerics.seed"], 7);
}

TEST_F(Load, another_seed_draws_other_slipping_times) {
  output_of("load --config small.ini -o a.h5 --until 4e-4 --seed 7");
  output_of("load --config small.ini -o b.h5 --until 4e-4 --seed 8");
  const Outcome diff = run("analyze diff a.h5 b.h5");
  EXPECT_EQ(diff.exit_code, kFailed);
  EXPECT_NE(diff.out.find("/state/junctions/repin_time"), std::string::npos) << diff.out;
}

TEST_F(Load, checkpoints_on_the_way_equal_runs_that_end_there) {
  output_of(
      "load --config small.ini -o a.h5 --until 4e-4 --checkpoint-every 2e-4 --checkpoint-at 0 "
      "1e-4");
  EXPECT_EQ(checksum_of("a-t0.000400000.h5"), checksum_of("a.h5"));
  for (const std::string t : {"0", "1e-4", "2e-4"}) {
    output_of("load --config small.ini -o at" + t + ".h5 --until " + t);
  }
  EXPECT_EQ(checksum_of("a-t0.000000000.h5"), checksum_of("at0.h5"));
  EXPECT_EQ(checksum_of("a-t0.000100000.h5"), checksum_of("at1e-4.h5"));
  EXPECT_EQ(checksum_of("a-t0.000200000.h5"), checksum_of("at2e-4.h5"));
}

TEST_F(Load, checkpoints_on_the_way_are_named_after_the_output) {
  fs::create_directory(path("sub"));
  output_of("load --config small.ini -o sub/noext --until 1e-4 --checkpoint-at 1e-4 2e-5 -q");
  const Files all = files();
  EXPECT_EQ(all.size(), 5U);  // small.ini, sub/ and three checkpoints
  for (const char* name : {"sub/noext", "sub/noext-t0.000020000", "sub/noext-t0.000100000"}) {
    EXPECT_TRUE(all.contains(name)) << name;
  }
}

TEST_F(Load, names_checkpoints_on_the_way_in_one_line) {
  const std::string load = "load --config small.ini -o a.h5 --until 1e-4 --record r.h5 --force";
  const auto lines = lines_of(output_of(load + " --checkpoint-every 1e-5"));
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[2], "wrote 10 checkpoints on the way: a-t0.000010000.h5 ... a-t0.000100000.h5");
  EXPECT_EQ(lines[3] + "\n", "wrote a.h5  " + sum_line("a.h5").substr(0, 79) + "\n");
  EXPECT_EQ(lines[4] + "\n", "wrote r.h5  " + sum_line("r.h5").substr(0, 79) + "\n");
  EXPECT_NE(output_of(load + " --checkpoint-at 5e-5")
                .find("\nwrote 1 checkpoint on the way: a-t0.000050000.h5\n"),
            std::string::npos);
  EXPECT_EQ(output_of(load).find("on the way"), std::string::npos);
}

TEST_F(Load, accounts_for_damping_and_for_the_junctions_apart) {
  output_of("load --config small.ini -o a.h5");
  // Pulled a little, then let go: the junctions give back what they took.
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
  EXPECT_EQ(out.find("dissipated"), std::string::npos);
}

TEST_F(Load, record_samples_at_multiples_of_the_interval) {
  output_of("load --config small.ini -o a.h5 --until 1.1e-4 --record r.h5 --record-every 2e-5");
  const std::vector<double> time = json_of("analyze loading r.h5 --json")["time"];
  ASSERT_EQ(time.size(), 7U);
  for (std::size_t n = 0; n < 6; ++n) EXPECT_NEAR(time[n], static_cast<double>(n) * 2e-5, 1e-15);
  EXPECT_NEAR(time.back(), 1.1e-4, 1e-15);
}

TEST_F(Load, what_is_not_a_multiple_of_the_time_step_is_done_at_the_nearest_step) {
  output_of(
      "load --config small.ini -o a.h5 --until 1.1e-5 --record r.h5 --record-every 3.3e-7 "
      "--checkpoint-every 1.3e-6 -q");
  const std::vector<double> time = json_of("analyze loading r.h5 --json")["time"];
  ASSERT_EQ(time.size(), 35U);
  for (std::size_t n = 0; n < 34; ++n) {
    EXPECT_NEAR(time[n], static_cast<double>(n) * 3.3e-7, 1.001e-7) << n;  // half a step
  }
  EXPECT_EQ(files().size(), 11U);  // small.ini, a.h5, r.h5 and 8 checkpoints on the way
}

TEST_F(Load, recording_changes_nothing) {
  output_of("load --config small.ini -o a.h5 --until 4e-4 --record r.h5 --checkpoint-every 1e-4");
  output_of("load --config small.ini -o b.h5 --until 4e-4");
  EXPECT_EQ(checksum_of("a.h5"), checksum_of("b.h5"));
}

}  // namespace
}  // namespace rupture::testing
