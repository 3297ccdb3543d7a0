#include "rupture/checkpoint/checkpoint.hpp"

#include <fmt/format.h>

#include <chrono>
#include <limits>
#include <thread>

#include "fixtures.hpp"
#include "rupture/checkpoint/compare.hpp"

namespace rupture {
namespace {

namespace fs = std::filesystem;

using testing::expect_contains;
using testing::failure_of;
using testing::slurp;
using testing::small_checkpoint;

class CheckpointFile : public testing::InFolder {
 protected:
  std::string write(const Checkpoint& checkpoint) {
    return write_checkpoint(file("x.h5"), checkpoint, IfExists::replace);
  }

  // The refusal to read the small checkpoint after `change` to its content, properly sealed.
  template <class Work>
  std::string refusal_after(const Work& change) {
    write(small_checkpoint());
    Content content = read_content(file("x.h5"));
    change(content);
    write_content(file("x.h5"), FileKind::checkpoint, content, IfExists::replace);
    return failure_of([&] { read_checkpoint(file("x.h5")); });
  }
};

double sum_with_padding(const Field& field) {
  double sum = 0;
  for (Eigen::Index j = -1; j <= field.Nz(); ++j) {
    for (Eigen::Index i = 0; i < field.stride(); ++i) sum += std::abs(field.row(j)[i]);
  }
  return sum;
}

TEST_F(CheckpointFile, returns_the_same_bits) {
  const Checkpoint written = small_checkpoint();
  const std::string checksum = write(written);
  const Checkpoint read = read_checkpoint(file("x.h5"));
  EXPECT_EQ(read.parameters, written.parameters);
  EXPECT_EQ(read.provenance, written.provenance);
  EXPECT_EQ(state_content(read.state), state_content(written.state));
  EXPECT_TRUE((read.state.junctions.repin_time == written.state.junctions.repin_time).all());
  EXPECT_TRUE(std::signbit(read.state.u_x(0, 0)));
  EXPECT_EQ(checksum, content_checksum(written.parameters, written.state));
  EXPECT_EQ(checksum, content_checksum(read.parameters, read.state));
  EXPECT_EQ(checksum, verify_file(file("x.h5")).checksum);
  EXPECT_EQ(identify(file("x.h5")), FileKind::checkpoint);
}

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

TEST_F(CheckpointFile, leaves_the_padding_of_fields_zero) {
  write(small_checkpoint());
  const State state = read_checkpoint(file("x.h5")).state;
  for (const Field* field : {&state.u_x, &state.v_z, &state.f_z}) {
    EXPECT_EQ(sum_with_padding(*field), [&] {
      double sum = 0;
      for (Eigen::Index j = 0; j < field->Nz(); ++j) {
        for (Eigen::Index i = 0; i < field->Nx(); ++i) sum += std::abs((*field)(i, j));
      }
      return sum;
    }());
  }
}

TEST_F(CheckpointFile, of_the_reference_lattice_survives) {
  Checkpoint written;
  written.state = State(written.parameters);
  written.state.v_x(56, 30) = 0.25;
  const std::string checksum = write(written);
  EXPECT_EQ(content_checksum(read_checkpoint(file("x.h5")).parameters,
                             read_checkpoint(file("x.h5")).state),
            checksum);
  EXPECT_LT(fs::file_size(file("x.h5")), 300000U);
}

TEST_F(CheckpointFile, of_equal_content_is_equal_bytes_at_any_time) {
  write(small_checkpoint());
  const std::string first = slurp(file("x.h5"));
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5's times count seconds
  const std::vector<std::string> churn(100, std::string(10000, 'x'));
  write_checkpoint(file("y.h5"), small_checkpoint(), IfExists::refuse);
  EXPECT_EQ(slurp(file("y.h5")), first);
  EXPECT_EQ(churn.size(), 100U);
}

TEST_F(CheckpointFile, names_every_parameter_by_its_table_row_with_its_unit) {
  const Content content = parameters_content(testing::small_parameters());
  EXPECT_EQ(content.size(), parameter_table().size());
  EXPECT_EQ(content.at("/parameters/slider/L"), make_scalar(0.04, "m"));
  EXPECT_EQ(content.at("/parameters/junctions/N_s"), make_scalar<std::int64_t>(3, "1"));
  EXPECT_EQ(content.at("/parameters/junctions/f_new"), make_text("f_slip"));
}

TEST_F(CheckpointFile, stores_pinned_junctions_with_repin_time_zero) {
  const Content content = state_content(small_checkpoint().state);
  const auto slipping = read_array<std::uint8_t>(content, "/state/junctions/slipping", {5, 3});
  const auto repin = read_array<double>(content, "/state/junctions/repin_time", {5, 3});
  EXPECT_EQ(slipping[0], 1);
  EXPECT_GT(repin[0], 0);
  EXPECT_EQ(slipping[1], 0);
  EXPECT_EQ(repin[1], 0);
}

TEST_F(CheckpointFile, stores_the_origin_of_a_clock_that_was_changed_and_of_no_other) {
  Checkpoint checkpoint = small_checkpoint();
  EXPECT_FALSE(state_content(checkpoint.state).contains("/state/clock/origin_step"));
  checkpoint.state.clock = {1000, 1.0 / 3.0};
  const Content content = state_content(checkpoint.state);
  EXPECT_EQ(content.at("/state/clock/origin_step"), make_scalar<std::int64_t>(1000, "1"));
  EXPECT_EQ(content.at("/state/clock/origin_time"), make_scalar(1.0 / 3.0, "s"));
  EXPECT_NE(write(checkpoint), content_checksum(checkpoint.parameters, small_checkpoint().state));
  EXPECT_EQ(read_checkpoint(file("x.h5")).state.clock, checkpoint.state.clock);
}

TEST_F(CheckpointFile, with_an_impossible_clock_is_refused) {
  const auto refusal_of = [&](std::int64_t step, double t) {
    return refusal_after([&](Content& c) {
      c["/state/clock/origin_step"] = make_scalar(step, "1");
      c["/state/clock/origin_time"] = make_scalar(t, "s");
    });
  };
  expect_contains(refusal_of(1234568, 0.1), "/state/clock/origin_step = 1234568; expected 0");
  expect_contains(refusal_of(1000, -0.1), "/state/clock/origin_time = -0.1 s; expected a time");
  expect_contains(refusal_of(0, 0.0), "/state/clock/origin_time = 0 s; expected a time above 0");
  expect_contains(
      refusal_after([](Content& c) { c["/state/clock/origin_time"] = make_scalar(0.1, "s"); }),
      "/state/clock/origin_step is missing");
}

TEST_F(CheckpointFile, with_nan_is_not_written) {
  Checkpoint checkpoint = small_checkpoint();
  checkpoint.state.v_x(2, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(failure_of([&] { write(checkpoint); }),
            file("x.h5").string() +
                ": /state/v_x holds nan at index 7 of [4][5]; only finite numbers are stored");
  EXPECT_TRUE(names().empty());
}

TEST_F(CheckpointFile, with_a_nan_repin_time_is_not_written) {
  Checkpoint checkpoint = small_checkpoint();
  checkpoint.state.junctions.repin_time(0, 1) = std::numeric_limits<double>::quiet_NaN();
  expect_contains(failure_of([&] { write(checkpoint); }), "/state/junctions/repin_time holds nan");
}

TEST_F(CheckpointFile, lacking_a_dataset_is_refused) {
  expect_contains(refusal_after([](Content& c) { c.erase("/state/u_z"); }),
                  "x.h5: /state/u_z is missing; expected float64 of shape [4][5]");
  expect_contains(refusal_after([](Content& c) { c.erase("/parameters/slider/E"); }),
                  "/parameters/slider/E is missing; expected one float64");
}

TEST_F(CheckpointFile, of_a_build_without_a_later_parameter_has_its_default) {
  write(small_checkpoint());
  Content content = read_content(file("x.h5"));
  for (const char* name :
       {"slider/support", "junctions/law", "junctions/mu_new", "junctions/v_slow"}) {
    content.erase(std::string("/parameters/") + name);
  }
  const auto checksum =
      write_content(file("old.h5"), FileKind::checkpoint, content, IfExists::refuse);
  const Checkpoint read = read_checkpoint(file("old.h5"));
  EXPECT_EQ(read.parameters, small_checkpoint().parameters);
  EXPECT_EQ(read.parameters.support, Support::foundation);
  EXPECT_EQ(read.checksum, checksum);
  EXPECT_EQ(verify_file(file("old.h5")).checksum, checksum);
  EXPECT_EQ(content_checksum(read.parameters, read.state), checksum);
}

TEST_F(CheckpointFile, with_a_dataset_too_many_is_refused) {
  expect_contains(refusal_after([](Content& c) { c["/state/extra"] = make_text("x"); }),
                  "x.h5: /state/extra is not part of a checkpoint: use a newer rupture");
  expect_contains(refusal_after([](Content& c) { c["/parameters/slider/X"] = make_text("x"); }),
                  "/parameters/slider/X is no parameter of this build: use a newer rupture");
}

TEST_F(CheckpointFile, whose_shapes_contradict_its_parameters_is_refused) {
  expect_contains(refusal_after([](Content& c) {
                    c["/parameters/junctions/N_s"] = make_scalar<std::int64_t>(4, "1");
                  }),
                  "/state/junctions/repin_time holds float64 of shape [5][3]; expected float64 of "
                  "shape [5][4]");
}

TEST_F(CheckpointFile, with_invalid_parameters_is_refused) {
  expect_contains(
      refusal_after([](Content& c) { c["/parameters/junctions/f_new"] = make_text("both"); }),
      "junctions.f_new = 'both' is unknown");
  expect_contains(
      refusal_after([](Content& c) { c["/parameters/slider/B"] = make_scalar(-1.0, "m"); }),
      "slider.B = -1 is out of range");
  expect_contains(
      refusal_after([](Content& c) { c["/parameters/numerics/dt"] = make_scalar(0.5, "s"); }),
      "numerics.dt = 0.5 s is unstable");
}

TEST_F(CheckpointFile, with_contradictory_junctions_is_refused) {
  const auto set_slipping = [](std::uint8_t value) {
    return [value](Content& c) {
      c.at("/state/junctions/slipping").bytes[0] = static_cast<std::byte>(value);
    };
  };
  expect_contains(refusal_after(set_slipping(2)), "junction 0 of block 0 has");
  expect_contains(refusal_after(set_slipping(0)), "expected 0 and 0 s if it is pinned");
}

TEST_F(CheckpointFile, at_an_impossible_step_is_refused) {
  const auto refusal_at = [&](const char* path, std::int64_t step) {
    return refusal_after([&](Content& c) { c[path] = make_scalar(step, "1"); });
  };
  expect_contains(refusal_at("/state/step", -1),
                  "/state/step = -1; expected 0 or more and at most 9007199254740992");
  expect_contains(refusal_at("/state/step", (std::int64_t{1} << 53U) + 1),
                  "/state/step = 9007199254740993; expected 0");
  expect_contains(refusal_at("/state/drive/origin_step", -1), "/state/drive/origin_step = -1");
  expect_contains(refusal_at("/state/drive/origin_step", 1234568),
                  "/state/drive/origin_step = 1234568; expected 0 or more and at most 1234567");
}

TEST_F(CheckpointFile, whose_datasets_are_not_as_written_is_refused) {
  expect_contains(refusal_after([](Content& c) { c.at("/state/u_x").unit = "mm"; }),
                  "x.h5: /state/u_x is in mm; expected m");
  expect_contains(refusal_after([](Content& c) { c.at("/parameters/slider/L").unit = "km"; }),
                  "x.h5: /parameters/slider/L is in km; expected m");
  expect_contains(refusal_after([](Content& c) {
                    c.at("/parameters/junctions/law").bytes.push_back(std::byte{0});
                  }),
                  "/parameters/junctions/law holds its value in a form that rupture never writes");
}

/// Of the simplified law: springs 0, 2 and 4 are slipping, spring 1 has never broken.
Checkpoint single_springs() {
  Checkpoint checkpoint;
  Parameters& p = checkpoint.parameters;
  p = testing::small_parameters();
  p.law = Law::simplified;
  p.f_new = NewForce::zero;
  checkpoint.state = testing::small_state(p);
  Junctions& junctions = checkpoint.state.junctions;
  for (const Eigen::Index i : {0, 2, 4}) junctions.repin_time(i, 0) = Junctions::unknown;
  junctions.slow_until.col(0) << 0.1, 0.0, -0.2, -0.3, 0.4;
  return checkpoint;
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
                 .event = {{}, 0.25, 0.5, {}, {}},
                 .last_rupture = 0.5,
                 .spanned = true,
                 .quiet_steps = 500,
                 .arrived_below = 0.25};
  EXPECT_EQ(write(written), without) << "it is no part of the content that is checksummed";
  EXPECT_EQ(read_checkpoint(file("x.h5")).run, written.run);
}

TEST_F(CheckpointFile, of_an_impossible_run_is_refused) {
  const auto times = [](const std::vector<double>& values) {
    return make_array<double>(values, {values.size()}, "s");
  };
  const auto refusal_with = [&](const char* path, const Dataset& dataset) {
    return refusal_after([&](Content& content) {
      for (const char* step : {"first_step", "last_break", "ruptures"}) {
        content[std::string("/run/") + step] = make_scalar<std::int64_t>(7, "1");
      }
      for (const char* truth : {"leading_edge_ruptured", "spanned"}) {
        content[std::string("/run/") + truth] = make_scalar<std::uint8_t>(0, "1");
      }
      content["/run/last_rupture"] = make_scalar(0.5, "s");
      content["/run/event"] = times({-1.0, 0.25, 0.5, -1.0, -1.0});
      content[path] = dataset;
    });
  };
  const auto integer = [](std::int64_t value) { return make_scalar(value, "1"); };
  expect_contains(refusal_with("/run/first_step", integer(-1)),
                  "/run/first_step = -1; expected 0 to 1234567");
  expect_contains(refusal_with("/run/last_break", integer(6)),
                  "/run/last_break = 6; expected 7 to 1234567");
  expect_contains(refusal_with("/run/ruptures", integer(-2)), "/run/ruptures = -2; expected 0 to");
  expect_contains(refusal_with("/run/leading_edge_ruptured", make_scalar<std::uint8_t>(2, "1")),
                  "/run/leading_edge_ruptured = 2; expected 0 or 1");
  expect_contains(refusal_with("/run/event", times({0.1, 0.6, 0.5, -1.0, -1.0})),
                  "/run/event holds 0.6; expected 0 to /run/last_rupture = 0.5, or -1 for no");
  expect_contains(refusal_with("/run/more", integer(0)), "/run/more is not part of a checkpoint");
}

TEST_F(CheckpointFile, of_single_springs_returns_the_same_bits) {
  const Checkpoint written = single_springs();
  const std::string checksum = write(written);
  const Checkpoint read = read_checkpoint(file("x.h5"));
  EXPECT_EQ(read.parameters, written.parameters);
  EXPECT_EQ(state_content(read.state), state_content(written.state));
  EXPECT_TRUE((read.state.junctions.repin_time == written.state.junctions.repin_time).all());
  EXPECT_TRUE((read.state.junctions.slow_until == written.state.junctions.slow_until).all());
  EXPECT_EQ(checksum, content_checksum(read.parameters, read.state));
}

TEST_F(CheckpointFile, of_single_springs_alone_holds_the_end_of_slow_slip) {
  const char* path = "/state/junctions/slow_until";
  const auto slow_until = read_array<double>(state_content(single_springs().state), path, {5, 1});
  EXPECT_EQ(slow_until, (std::vector<double>{0.1, 0.0, -0.2, -0.3, 0.4}));
  EXPECT_FALSE(state_content(small_checkpoint().state).contains(path));
  expect_contains(refusal_after([&](Content& c) { c[path] = c.at("/state/junctions/repin_time"); }),
                  "/state/junctions/slow_until is not part of a checkpoint");
}

TEST_F(CheckpointFile, with_contradictory_single_springs_is_refused) {
  const auto refusal = [&](const Content& content) {
    return failure_of([&] { checkpoint_from(content); });
  };
  const auto content_of = [](const Checkpoint& checkpoint) {
    Content content = parameters_content(checkpoint.parameters);
    content.merge(state_content(checkpoint.state));
    return content;
  };
  Content lacking = content_of(single_springs());
  lacking.erase("/state/junctions/slow_until");
  expect_contains(refusal(lacking), "/state/junctions/slow_until is missing");
  Checkpoint never_broken = single_springs();
  never_broken.state.junctions.slow_until(2, 0) = 0.0;
  expect_contains(refusal(content_of(never_broken)), "junction 0 of block 2 has");
  Checkpoint with_repin_time = single_springs();
  with_repin_time.state.junctions.repin_time(4, 0) = 0.1;
  expect_contains(refusal(content_of(with_repin_time)),
                  "junction 0 of block 4 has /state/junctions/repin_time = 0.1 s");
  Content many = content_of(small_checkpoint());
  many["/parameters/junctions/f_new"] = make_text("zero");
  many["/parameters/junctions/law"] = make_text("simplified");
  expect_contains(refusal(many), "holds float64 of shape [5][3]; expected float64 of shape [5][1]");
}

}  // namespace
}  // namespace rupture
