// Files of ours whose content contradicts itself: what readers, verify and seal say.
#include <tuple>

#include "file_rows.hpp"

namespace rupture::testing {
namespace {

Change step(const char* path, std::int64_t value) {
  return set(path, make_scalar(value, "1"));
}
Change clock(std::int64_t origin, double time) {
  return all({step("/state/clock/origin_step", origin),
              set("/state/clock/origin_time", make_scalar(time, "s"))});
}
/// The first element of an array of bytes.
Change first(const char* path, std::uint8_t value) {
  return content([=](Content& c) { c.at(path).bytes[0] = std::byte{value}; });
}
/// The memory of a run, of which one number or list is not possible.
Change run_with(const char* path, const Dataset& dataset) {
  const Dataset no = make_scalar<std::uint8_t>(0, "1");
  return all({step("/run/first_step", 7), step("/run/last_break", 7), step("/run/ruptures", 7),
              set("/run/leading_edge_ruptured", no), set("/run/spanned", no),
              set("/run/last_rupture", make_scalar(0.5, "s")),
              set("/run/event", array(Reals{-1.0, 0.25, 0.5, -1.0, -1.0}, "s")),
              set(path, dataset)});
}
Dataset integer(std::int64_t value) {
  return make_scalar(value, "1");
}

TEST_F(AnyFile, that_is_a_checkpoint_and_contradicts_itself_is_refused) {
  write_checkpoint_file();
  const std::string junction = ": junction 0 of block 0 has /state/junctions/slipping = ";
  expect_rows(
      {kOfCheckpoint},
      {{set("/parameters/junctions/law", make_text("\n\x1b[2J")),
        ": junctions.law = '??[2J' is unknown: choose one of reference, simplified, decaying, "
        "distance"},
       {clock(1234568, 0.1), ": /state/clock/origin_step = 1234568; expected 0 or more and ..."},
       {clock(1000, -0.1), ": /state/clock/origin_time = -0.1 s; expected a time above 0"},
       {clock(0, 0.0), ": /state/clock/origin_time = 0 s; expected a time above 0"},
       {set("/state/clock/origin_time", make_scalar(0.1, "s")),
        ": /state/clock/origin_step is missing; expected one int64"},
       {without("/state/u_z"), ": /state/u_z is missing; expected float64 of shape [4][5]"},
       {without("/parameters/slider/E"), ": /parameters/slider/E is missing; expected one float64"},
       {set("/state/extra", make_text("x")),
        ": /state/extra is not part of a checkpoint: use a newer rupture, or remove it if another "
        "program added it"},
       {set("/parameters/slider/X", make_text("x")),
        ": /parameters/slider/X is no parameter of this build: use a newer rupture"},
       {set("/parameters/junctions/N_s", integer(4)),
        ": /state/junctions/repin_time holds float64 of shape [5][3]; expected float64 of shape "
        "[5][4]"},
       {set("/parameters/junctions/f_new", make_text("both")),
        ": junctions.f_new = 'both' is unknown..."},
       {set("/parameters/slider/B", make_scalar(-1.0, "m")), ": slider.B = -1 is out of range..."},
       {set("/parameters/numerics/dt", make_scalar(0.5, "s")),
        ": numerics.dt = 0.5 s is unstable..."},
       {first("/state/junctions/slipping", 2), junction + "2 and ..."},
       {first("/state/junctions/slipping", 0),
        junction + "0 and ...; expected 0 and 0 s if it is pinned, 1 and a time if it is slipping"},
       {set("/state/junctions/slow_until", make_scalar(0.0, "s")),
        ": /state/junctions/slow_until is not part of a checkpoint..."},
       {step("/state/step", -1),
        ": /state/step = -1; expected 0 or more and at most 9007199254740992"},
       {step("/state/step", (std::int64_t{1} << 53U) + 1),
        ": /state/step = 9007199254740993; expected 0..."},
       {step("/state/drive/origin_step", -1), ": /state/drive/origin_step = -1; ..."},
       {step("/state/drive/origin_step", 1234568),
        ": /state/drive/origin_step = 1234568; expected 0 or more and at most 1234567"},
       {with_unit("/state/u_x", "mm"), ": /state/u_x is in mm; expected m"},
       {with_unit("/parameters/slider/L", "km"), ": /parameters/slider/L is in km; expected m"},
       {content(
            [](Content& c) { c.at("/parameters/junctions/law").bytes.push_back(std::byte{0}); }),
        ": /parameters/junctions/law holds its value in a form that rupture never writes",
        kSealed}});
  for (const auto& [path, dataset, sentence] :
       std::vector<std::tuple<const char*, Dataset, const char*>>{
           {"/run/first_step", integer(-1), " = -1; expected 0 to 1234567"},
           {"/run/last_break", integer(6), " = 6; expected 7 to 1234567"},
           {"/run/ruptures", integer(-2), " = -2; expected 0 to ..."},
           {"/run/leading_edge_ruptured", make_scalar<std::uint8_t>(2, "1"),
            " = 2; expected 0 or 1"},
           {"/run/event", array(Reals{0.1, 0.6, 0.5, -1.0, -1.0}, "s"),
            " holds 0.6; expected 0 to /run/last_rupture = 0.5, or -1 for no rupture"},
           {"/run/more", integer(0), " is not part of a checkpoint..."}}) {
    const std::string says = std::string(": ") + path + sentence;
    expect_rows({kOfCheckpoint}, {{run_with(path, dataset), says, kSealed}});  // without its run
  }
}

TEST_F(AnyFile, of_single_springs_that_contradicts_itself_is_refused) {
  const char* const slow = "/state/junctions/slow_until";
  write_checkpoint_file(single_springs());
  expect_rows({kOfCheckpoint},
              {{without(slow), ": /state/junctions/slow_until is missing; expected float64 of ..."},
               {set("/parameters/junctions/law", make_text("reference")),
                ": /state/junctions/repin_time holds ...; expected float64 of shape [5][3]"},
               {content([=](Content& c) {
                  const Reals never_broken = {0.1, 0.0, 0.0, -0.3, 0.4};
                  c[slow] = make_array(std::span(never_broken), {5, 1}, "s");
                }),
                ": junction 0 of block 2 has ..."},
               {content([](Content& c) {
                  auto times = read_array<double>(c, "/state/junctions/repin_time", {5, 1});
                  times[4] = 0.1;
                  c["/state/junctions/repin_time"] =
                      make_array(std::span<const double>(times), {5, 1}, "s");
                }),
                ": junction 0 of block 4 has /state/junctions/repin_time = 0.1 s and ..."}});
}

Dataset counts(std::uint16_t of_all, std::uint16_t at_last) {
  std::vector<std::uint16_t> pinned(25, of_all);
  pinned[23] = at_last;
  return make_array(std::span<const std::uint16_t>(pinned), {5, 5}, "1");
}

TEST_F(AnyFile, that_is_a_record_and_contradicts_itself_is_refused) {
  write_record_file();
  Rows rows = {
      {set("/series/time", array(Reals{0, 1, 2, 3, 4}, "ms")),
       ": /series/time has the unit 'ms'; expected 's'"},
      {set("/series/time", array(Reals{0, 0.001, 0.002, 0.003, 0.00401}, "s")),
       ": /series/time holds 0.00401 at step 400; by the parameters it is 0.004 there"},
      {set("/series/x_drive", array(Reals{0, 1e-6, 2e-6, 0, 4e-6}, "m")),
       ": /series/x_drive holds 0 at step 300; ..."},
      {set("/series/pinned", counts(3, 4)), ": /series/pinned holds 4; expected 3 at most"},
      {set("/series/pinned", counts(2, 1)),
       ": /crossings/ lacks block 3, whose pinned fraction falls below 0.5 by step 400"},
      {set("/series/pinned", counts(1, 0)), ": /ruptures/ lacks block 3, whose pinned ..."},
      {set("/ruptures/block", array(Integers{0, 5})),
       ": /ruptures/block holds 5 at index 1; expected a block from 0 to 4"},
      {set("/ruptures/step", array(Integers{400, 0})),
       ": /ruptures/step holds 0 after 400, for block 4; ..."},
      {set("/ruptures/step", array(Integers{-1, 400})),
       ": /ruptures/step holds -1 after 0, for block 0; ..."},
      {set("/ruptures/time", array(Reals{0, 0.003}, "s")),
       ": /ruptures/time holds 0.003 at step 400; ..."},
      {set("/crossings/levels", array(Reals{0.5, 0.5})),
       ": /crossings/levels holds 0.5, 0.5; expected ..."},
      {set("/crossings/levels", array(Reals{0.3, 0.5})),
       ": /crossings/levels holds 0.3, 0.5; expected ..."},
      {set("/crossings/levels", array(Reals{0.5, 1.5})),
       ": /crossings/levels holds 0.5, 1.5; expected ..."},
      {set("/crossings/pinned_below", array(Reals{0.4})),
       ": /crossings/pinned_below holds 0.4; expected ..."},
      {set("/fields/step", array(Integers{400, 0})),
       ": /fields/step holds 400 and then 0; expected ascending steps"},
      {set("/series/x", array(Reals{0.0, 0.1, 0.2, 0.3, 0.4}, "m")),
       ": /series/x holds its value in a form that rupture never writes"},
      {set("/series/q", make_text("")),
       ": /series/q is not part of a record: use a newer rupture, or remove it if another program "
       "added it"},
      {without("/series/p"), ": /series/p is missing; expected float64 of shape [5][5]"},
      {without("/fields/u_z"), ": /fields/u_z is missing; expected float32 of shape [2][4][5]"}};
  for (const char* path :
       {"/crossings/levels", "/crossings/step", "/crossings/block", "/crossings/pinned_below"}) {
    rows.push_back({without(path), std::string(": ") + path + " is missing; ..."});
  }
  expect_rows({kOfRecord}, rows);
}

}  // namespace
}  // namespace rupture::testing
