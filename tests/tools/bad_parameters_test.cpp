// Bad options and parameters: one sentence, exit code 2, nothing written.
#include <fmt/format.h>

#include <ostream>

#include "rupture/model/parameters.hpp"
#include "tool_test.hpp"

namespace rupture::testing {
namespace {

/// A parameter assignment that load refuses, and what it says.
struct BadParameter {
  std::string assignment, sentence;
};

std::ostream& operator<<(std::ostream& out, const BadParameter& parameter) {
  return out << parameter.assignment;
}

class BadParameters : public ToolTest, public ::testing::WithParamInterface<BadParameter> {};

TEST_P(BadParameters, is_refused_by_load) {
  expect_refusal("load --config small.ini -o a.h5 --set " + GetParam().assignment, kUsage,
                 GetParam().sentence);
}

INSTANTIATE_TEST_SUITE_P(
    Parameters, BadParameters,
    ::testing::Values(
        BadParameter{"slidr.L=0.14", "unknown parameter 'slidr.L': did you mean 'slider.L'?"},
        BadParameter{"junctions.mus=1",
                     "unknown parameter 'junctions.mus': did you mean 'junctions.mu_s'?"},
        BadParameter{"V=1", "unknown parameter 'V': did you mean 'driving.V'?"},
        BadParameter{"slider.L", "--set slider.L has no '=': write --set NAME=VALUE"},
        BadParameter{"slider.L=", "slider.L = '' is not a number (unit m, mm, um or nm)"},
        BadParameter{"slider.L=long", "slider.L = 'long' is not a number (unit m, mm, um or nm)"},
        BadParameter{"slider.L=0.14N", "slider.L = '0.14N' is not a number (unit m, mm, um or nm)"},
        BadParameter{"slider.L=nan",
                     "slider.L = nan is out of range: give a value above 0 and at most 1000 "
                     "(unit m)"},
        BadParameter{"slider.L=inf",
                     "slider.L = inf is out of range: give a value above 0 and at most 1000 "
                     "(unit m)"},
        BadParameter{"slider.L=-1",
                     "slider.L = -1 is out of range: give a value above 0 and at most 1000 "
                     "(unit m)"},
        BadParameter{"driving.V=11",
                     "driving.V = 11 is out of range: give a value of at least -10 and at most 10 "
                     "(unit m/s)"},
        BadParameter{"slider.Nx=9.5", "slider.Nx = '9.5' is not a whole number (unit 1)"},
        BadParameter{"slider.Nx=2",
                     "slider.Nx = 2 is out of range: give a value of at least 3 and at most 65536 "
                     "(unit 1)"},
        BadParameter{"junctions.slipping_times=normal",
                     "junctions.slipping_times = 'normal' is unknown: choose one of gaussian, "
                     "exponential"},
        BadParameter{"slider.Nx=10",
                     "the lattice must be square, but L/(Nx-1) = 0.0155556 m and H/(Nz-1) = 0.0175 "
                     "m: change slider.L, slider.H, slider.Nx or slider.Nz (for instance slider.H "
                     "= 0.0622222222)"},
        BadParameter{"driving.h=0.01",
                     "driving.h = 0.01 m is on no row of blocks: give a multiple of the spacing "
                     "0.0175 m below slider.H"},
        BadParameter{"junctions.mu_d=0.5",
                     "junctions.mu_d = 0.5 exceeds junctions.mu_s = 0.4: a junction cannot slip at "
                     "more than its strength"},
        BadParameter{"numerics.dt=1e-5",
                     "numerics.dt = 1e-05 s is unstable: the limit for this lattice is 4.066e-06 "
                     "s"}),
    [](const auto& test) { return std::string("case") + std::to_string(test.index); });

using BadOptions = ToolTest;

TEST_F(BadOptions, seed_must_be_a_whole_number) {
  expect_refusal("load -o a.h5 --seed 1.5", kUsage,
                 "numerics.seed = '1.5' is not a whole number (unit 1)");
  expect_refusal("load -o a.h5 --seed abc", kUsage,
                 "numerics.seed = 'abc' is not a whole number (unit 1)");
  expect_refusal("load -o a.h5 --seed -1", kUsage,
                 "numerics.seed = -1 is out of range: give a value of at least 0 and at most "
                 "9e+15 (unit 1)");
}

TEST_F(BadOptions, number_too_large_for_its_type_is_out_of_range) {
  expect_refusal_with("load -o a.h5 --seed 99999999999999999999", kUsage, "out of range");
  expect_refusal_with("load -o a.h5 --set slider.L=1e400", kUsage, "out of range");
}

std::string not_seconds(const std::string& option, const std::string& value) {
  return option + " " + value + " is not a number (unit s, ms, us or ns); see rupture ";
}

TEST_F(BadOptions, times_of_other_tools_have_units_of_time_too) {
  output_of("load --config small.ini -o a.h5 --record r.h5 --until 1e-5");
  for (const std::string option : {"--until", "--for", "--until-quiet"}) {
    expect_refusal("restart a.h5 -o b.h5 " + option + " 10mm", kUsage,
                   not_seconds(option, "10mm") + "restart --help");
  }
  for (const std::string option : {"--from", "--to"}) {
    expect_refusal("analyze front r.h5 " + option + " 10mm", kUsage,
                   not_seconds(option, "10mm") + "analyze front --help");
  }
  expect_refusal("analyze events r.h5 --quiet-time 1Ms", kUsage,
                 not_seconds("--quiet-time", "1Ms") + "analyze events --help");
}

TEST_F(BadOptions, times_must_be_numbers_from_zero) {
  const std::string load = "load --config small.ini -o a.h5 ";
  for (const std::string value : {"abc", "10xs", "0.1m", "1,5"}) {
    for (const std::string option :
         {"--until", "--checkpoint-at", "--checkpoint-every", "--record-every"}) {
      expect_refusal(load + option + " " + value, kUsage,
                     not_seconds(option, value) + "load --help");
    }
  }
  for (const std::string value : {"nan", "inf", "-1"}) {
    for (const std::string option : {"--until", "--checkpoint-every", "--record-every"}) {
      expect_refusal(load + option + " " + value, kUsage,
                     option + " " + value + " makes no sense: give a number of at least 0");
    }
  }
  expect_refusal(load + "--until 1e300", kUsage,
                 "t = 1e+300 s is too long a time for steps of 2e-07 s");
}

TEST_F(BadOptions, other_numbers_have_no_units_of_time) {
  expect_refusal("prepare -o a.h5 --tau-bar 0.2ms", kUsage,
                 "--tau-bar 0.2ms is not a number (unit 1); see rupture prepare --help");
  expect_refusal(
      "prepare -o a.h5 --tau-bar 0.2 --x-trigger 20ms", kUsage,
      "--x-trigger 20ms is not a number (unit m, mm, um or nm); see rupture prepare --help");
  write("odd.ini", "until = 10 years\n");
  expect_refusal(
      "load --config odd.ini -o a.h5", kUsage,
      "odd.ini:1: until 10 years is not a number (unit s, ms, us or ns); see rupture load --help");
}

TEST_F(BadOptions, checkpoint_times_must_be_numbers_from_zero) {
  const std::string load = "load --config small.ini -o a.h5 --until 1e-4 --checkpoint-at ";
  for (const char* value : {"nan", "inf", "-inf"}) {
    expect_refusal_with(load + value, kUsage, std::string("--checkpoint-at ") + value);
  }
}

TEST_F(BadOptions, checkpoint_times_must_lie_in_the_run) {
  const std::string load = "load --config small.ini -o a.h5 --until 1e-4 --checkpoint-at ";
  expect_refusal(load + "2e-4", kUsage,
                 "--checkpoint-at 0.0002 is outside the run, 0 s to 0.0001 s");
  expect_refusal(load + "-1", kUsage, "--checkpoint-at -1 is outside the run, 0 s to 0.0001 s");
}

TEST_F(BadOptions, intervals_must_be_at_least_a_step) {
  const std::string load = "load --config small.ini -o a.h5 --until 1e-4 ";
  expect_refusal(load + "--checkpoint-every 1e-8", kUsage,
                 "--checkpoint-every is shorter than one time step");
  expect_refusal(load + "--record r.h5 --record-every 0", kUsage,
                 "--record-every is shorter than one time step");
  expect_refusal(load + "--record r.h5 --record-every 1.5e-7", kUsage,
                 "--record-every is shorter than one time step");
}

TEST_F(BadOptions, parts_of_a_record_must_make_sense) {
  const std::string load = "load --config small.ini -o a.h5 ";
  for (const std::string part : {"--crossings 0.2", "--fields 2e-5", "--record-every 1e-4"}) {
    expect_refusal(load + part, kUsage,
                   part.substr(0, part.find(' ')) + " needs a record: give --record as well");
  }
  expect_refusal(load + "--record r.h5 --fields 1e-9", kUsage,
                 "--fields is shorter than one time step");
  expect_refusal(load + "--record r.h5 --crossings 0.2,0.3", kUsage,
                 "--crossings 0.3 is recorded always: leave it out");
  for (const std::string value : {"0", "1.1", "-0.2", "nan", "a", "0.2,,0.5", ","}) {
    expect_refusal(
        load + "--record r.h5 --crossings=" + value, kUsage,
        "--crossings " + value + " makes no sense: a pinned fraction is above 0 and at most 1");
  }
}

TEST_F(BadOptions, conventions_of_fronts_must_make_sense) {
  output_of("load --config small.ini -o a.h5 --record r.h5 --until 1e-5 --crossings 0.5");
  const std::string front = "analyze front r.h5 ";
  for (const std::string value : {"1", "4", "-3"}) {
    expect_refusal(
        front + "--stencil " + value, kUsage,
        "--stencil " + value + " makes no sense: give an odd number of blocks from 3 on");
  }
  expect_refusal(front + "--stencils-at-ends both", kUsage,
                 "--stencils-at-ends both is not known: give neither, slow or fast");
  expect_refusal(front + "--ruptured-below 1.5", kUsage,
                 "--ruptured-below 1.5 makes no sense: a pinned fraction is above 0 and at most 1");
  for (const std::string command : {"front", "classify", "events", "slow-slip"}) {
    expect_refusal("analyze " + command + " r.h5 --ruptured-below 0.2", kFailed,
                   "the record does not tell when blocks fell below a pinned fraction of 0.2, only "
                   "of 0.5, 0.3: record it with --crossings 0.2");
  }
}

TEST_F(BadOptions, threads_must_be_a_few) {
  for (const std::string value : {"0", "-2", "1025"}) {
    expect_refusal("load --config small.ini -o a.h5 --threads " + value, kUsage,
                   "--threads " + value + " makes no sense: give a number from 1 to 1024");
  }
}

TEST_F(BadOptions, restart_wants_one_end) {
  output_of("load --config small.ini -o a.h5");
  expect_refusal("restart a.h5 -o b.h5", kUsage,
                 "when to stop? Give --until T, --for T or --until-quiet");
  expect_refusal("restart a.h5 -o b.h5 --for 1 --until 1", kUsage,
                 "--until and --for exclude each other: give one");
  expect_refusal("restart -o b.h5 --for 1", kUsage,
                 "no file was given: name a checkpoint to continue");
  expect_refusal("restart a.h5 a.h5 -o b.h5 --for 1", kUsage,
                 "'a.h5' is one file too many: name only a checkpoint to continue");
}

TEST_F(BadOptions, restart_cannot_go_back) {
  output_of("load --config small.ini -o a.h5 --until 1e-4");
  expect_refusal("restart a.h5 -o b.h5 --until 5e-5", kUsage,
                 "--until 5e-05 is before the checkpoint's time 0.0001 s");
}

TEST_F(BadOptions, quiet_time_must_be_a_number_from_zero) {
  output_of("load --config small.ini -o a.h5");
  for (const char* value : {"nan", "inf", "-3"}) {
    expect_refusal_with(std::string("restart a.h5 -o b.h5 --until 1e-4 --until-quiet=") + value,
                        kUsage, "--until-quiet");
  }
}

TEST_F(BadOptions, restart_keeps_what_its_row_says) {
  output_of("load --config small.ini -o a.h5");
  const Json was = json_of("analyze show a.h5 --json")["parameters"];
  for (const auto& info : parameter_table()) {
    const bool whole = was[info.name].is_number_integer();
    const std::string other =
        choices(info).empty() ? (whole ? "7" : "0.7") : std::string(choices(info).back());
    const Outcome outcome =
        run(fmt::format("restart a.h5 -o b.h5 -f --for 0 --set {}={}", info.name, other));
    const bool kept = outcome.err.find(fmt::format("{} cannot change in a restart: the state was "
                                                   "made with ",
                                                   info.name)) != std::string::npos;
    EXPECT_EQ(kept, info.restart == Restart::must_keep) << info.name << ": " << outcome.err;
  }
}

TEST_F(BadOptions, restart_keeps_the_lattice) {
  output_of("load --config small.ini -o a.h5");
  for (const auto& [name, value, was] :
       {std::tuple{"slider.Nx", "17", "9"}, std::tuple{"slider.L", "0.15", "0.14"},
        std::tuple{"junctions.N_s", "50", "100"}}) {
    expect_refusal(
        std::string("restart a.h5 -o b.h5 --for 1e-5 --set ") + name + "=" + value, kUsage,
        std::string(name) + " cannot change in a restart: the state was made with " + was);
  }
  expect_refusal("restart a.h5 -o b.h5 --for 1e-5 --set slider.M=1e-9", kUsage,
                 "numerics.dt = 2e-07 s is unstable: the limit for this lattice is 4.677e-10 s");
}

TEST_F(BadOptions, configuration_must_be_readable) {
  expect_refusal(
      "load --config gone.ini -o a.h5", kFailed,
      "cannot read the configuration file gone.ini; give the path of a readable INI file");
  expect_refusal("load --config /dev/zero -o a.h5", kFailed,
                 "the configuration file /dev/zero is longer than 100000 bytes; give the path of "
                 "an INI file");
  write("odd.ini", "\n[slider]\nslider.L\n");
  expect_refusal_with("load --config odd.ini -o a.h5", kUsage, "odd.ini:3: ");
}

TEST_F(BadOptions, settings_are_given_once_in_each_place) {
  const std::string load = "load -o a.h5 ";
  for (const std::string twice :
       {"--seed 1 --set numerics.seed=2", "--set numerics.seed=1 --set numerics.seed=1"}) {
    expect_refusal(load + twice, kUsage, "numerics.seed is given twice: give it once");
  }
  for (const std::string twice :
       {"seed = 1\n[numerics]\nseed = 1\n", "[numerics]\nseed = 1\nseed = 2\n",
        "numerics.seed = 1\n\nset = numerics.seed=1\n"}) {
    write("twice.ini", twice);
    expect_refusal(load + "--config twice.ini", kUsage,
                   "twice.ini:3: numerics.seed is given twice: give it once");
  }
  write("twice.ini", "until = 1\n\nuntil = 1\n");
  expect_refusal_with(load + "--config twice.ini", kUsage, "twice.ini:3: option 'until'");
}

TEST_F(BadOptions, parameters_of_a_configuration_are_checked_alike) {
  write("bad.ini", "[slider]\nLL = 0.14\n");
  expect_refusal("load --config bad.ini -o a.h5", kUsage,
                 "bad.ini:2: unknown parameter 'slider.LL': did you mean 'slider.L'?");
  write("bad.ini", "[slider]\nL = long\n");
  expect_refusal("load --config bad.ini -o a.h5", kUsage,
                 "bad.ini:2: slider.L = 'long' is not a number (unit m, mm, um or nm)");
  write("bad.ini", "[driving]\nV = 11\n");
  expect_refusal("load --config bad.ini -o a.h5", kUsage,
                 "bad.ini:2: driving.V = 11 is out of range: give a value of at least -10 and at "
                 "most 10 (unit m/s)");
  write("bad.ini", "untill = 1\n");
  expect_refusal_with("load --config bad.ini -o a.h5", kUsage, "untill");
}

TEST_F(BadOptions, configuration_must_not_be_a_folder) {
  expect_refusal_with("load --config . -o a.h5", kFailed, "configuration");
}

TEST_F(BadOptions, load_takes_no_file) {
  expect_refusal_with("load small.ini -o a.h5", kUsage, "small.ini");
}

TEST_F(BadOptions, slider_that_cannot_bear_its_load_is_refused) {
  expect_refusal_with(
      "load --config small.ini -o a.h5 --set junctions.mu_s=0.01 --set junctions.mu_d=0.001",
      kFailed, "|f|/f_thres");
  expect_refusal("load --config small.ini -o a.h5 --set slider.E=1e-300", kFailed,
                 "no equilibrium under F_N = 1920 N was found: the load is too large for slider.E "
                 "= 1e-300 Pa or the slider tips over");
}

TEST_F(BadOptions, load_that_turns_the_lattice_inside_out_is_refused) {
  expect_refusal_with("load --config small.ini -o a.h5 --set slider.F_N=1e9", kFailed, "F_N");
  expect_refusal_with("load --config small.ini -o a.h5 --set slider.E=1", kFailed, "slider.E");
}

TEST_F(BadOptions, stability_limit_is_a_number) {
  for (const std::string mass : {"1e-298", "1e-300"}) {
    const Outcome outcome = run("load --config small.ini -o a.h5 --set slider.M=" + mass);
    EXPECT_EQ(outcome.exit_code, kUsage);
    EXPECT_EQ(outcome.err.find("nan"), std::string::npos) << outcome.err;
  }
}

TEST_F(BadOptions, too_many_junctions_for_a_record_are_refused) {
  expect_refusal_with("load --config small.ini -o a.h5 --record r.h5 --set junctions.N_s=70000",
                      kUsage, "junctions.N_s = 70000 is too large for a record");
}

TEST_F(BadOptions, SLOW_lattice_too_large_for_the_memory_is_refused) {
  if (RUPTURE_SANITIZED) GTEST_SKIP() << "AddressSanitizer needs more memory than the limit";
  const RunOptions two_gigabytes = {.memory = std::uint64_t{2} << 30U};
  constexpr const char* sentence = "not enough memory for a lattice of this size";
  for (const std::string how : {"", " --dry-run"}) {
    expect_refusal(
        "load -o a.h5 --set slider.Nx=65536 --set slider.Nz=65536 --set slider.H=0.14 "
        "--set driving.h=0 --set numerics.dt=1e-11" +
            how,
        kUsage, "slider.Nx x slider.Nz = 4294967296: an equilibrium has at most 7000000 blocks",
        two_gigabytes);
  }
  expect_refusal(
      "load -o a.h5 --set slider.Nx=2801 --set slider.Nz=2401 --set slider.H=0.12 "
      "--set driving.h=0 --set numerics.dt=1e-10",
      kFailed, sentence, two_gigabytes);
  expect_refusal(
      "load --config small.ini -o a.h5 --set junctions.N_s=1000000 --set slider.Nx=129 "
      "--set slider.Nz=65 --set numerics.dt=1e-8",
      kFailed, sentence, two_gigabytes);
}

}  // namespace
}  // namespace rupture::testing
