#include <fmt/core.h>
#include <gtest/gtest.h>

#include <charconv>
#include <map>
#include <random>

#include "rupture/model/user_text.hpp"

namespace rupture::testing {

double number(const std::string& text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  EXPECT_EQ(std::from_chars(text.data(), end, value).ptr, end) << text;
  return value;
}

TEST(InUnit, shifts_the_exponent_and_nothing_else) {
  const std::map<std::string, std::string> in_seconds = {
      {"10ms", "10e-3"},    {"0.8 s", "0.8"},     {"20us", "20e-6"}, {"1.5e1 ms", "1.5e-2"},
      {"-3ns", "-3e-9"},    {"+1E+2us", "1e-4"},  {"1e-5", "1e-5"},  {"1.20", "1.20"},
      {"2  ms", "2e-3"},    {"7µs", "7e-6"},      {"7μs", "7e-6"},   {"inf", "inf"},
      {"1e400ms", "1e397"}, {"1e-400s", "1e-400"}};
  for (const auto& [text, plain] : in_seconds) EXPECT_EQ(in_unit(text, "s"), plain) << text;
}

TEST(InUnit, gives_the_bits_of_the_plain_number) {
  EXPECT_EQ(number(*in_unit("10ms", "s")), 0.01);
  std::mt19937 random(1);
  std::uniform_int_distribution<int> digits(1, 99999);
  for (int n = 0; n < 10000; ++n) {
    const int whole = digits(random);
    EXPECT_EQ(number(*in_unit(fmt::format("{}us", whole), "s")),
              number(fmt::format("0.{:06}", whole)));
    EXPECT_EQ(number(*in_unit(fmt::format("{}MPa", whole), "Pa")), whole * 1e6);
  }
}

TEST(InUnit, takes_multiples_of_every_unit_of_a_parameter) {
  EXPECT_EQ(in_unit("22.5mm", "m"), "22.5e-3");
  EXPECT_EQ(in_unit("3GPa", "Pa"), "3e9");
  EXPECT_EQ(in_unit("0.4mm/s", "m/s"), "0.4e-3");
  EXPECT_EQ(in_unit("4MN/m", "N/m"), "4e6");
  EXPECT_EQ(in_unit("39.2 GN/m^2", "N/m^2"), "39.2e9");
  EXPECT_EQ(in_unit("1.92kN", "N"), "1.92e3");
  EXPECT_EQ(in_unit("75.6g", "kg"), "75.6e-3");
  EXPECT_EQ(in_unit("2kg", "kg"), "2");
  EXPECT_EQ(in_unit("3", "1"), "3");
  EXPECT_EQ(in_unit("1e-9223372036854775808mm", "m"), "1e-9223372036854775808") << "as good as 0";
}

TEST(InUnit, refuses_other_units_and_what_is_no_number) {
  for (const char* text : {"", "ms", "10xs", "10m", "10mm", "10 ms ", " 10ms", "1,5s", "10msms",
                           "1e", "10Ms", "10ks", "ten", "0x10", "10s ms", "--1s", "+-1s", "++1s"}) {
    EXPECT_EQ(in_unit(text, "s"), std::nullopt) << text;
  }
  EXPECT_EQ(in_unit("10Mm", "m"), std::nullopt);
  for (const char* text : {"1m", "1 ", "1 1", "1k"}) {
    EXPECT_EQ(in_unit(text, "1"), std::nullopt) << text;
  }
}

TEST(UnitsTaken, are_what_is_taken) {
  EXPECT_EQ(units_taken("s"), " (unit s, ms, us or ns)");
  EXPECT_EQ(units_taken("m/s"), " (unit m/s, mm/s, um/s or nm/s)");
  EXPECT_EQ(units_taken("N"), " (unit N, GN, MN, kN, mN, uN or nN)");
  EXPECT_EQ(units_taken("kg"), " (unit kg, g, Gg, Mg, mg, ug or ng)");
  EXPECT_EQ(units_taken("1"), "");
}

TEST(UnknownText, suggests_the_nearest_name_if_most_of_it_was_written) {
  const auto text = [](std::string_view word, const std::vector<std::string_view>& candidates) {
    return unknown_text("name", word, candidates, "help");
  };
  EXPECT_EQ(text("kitten", {"sitting", "mitten"}), "unknown name 'kitten': did you mean 'mitten'?");
  EXPECT_EQ(text("xyz", {"abc", "x.y", "xy"}), "unknown name 'xyz': did you mean 'xy'?");
  EXPECT_EQ(text("leaf", {"a.leaf", "leer"}), "unknown name 'leaf': did you mean 'a.leaf'?");
  EXPECT_EQ(text("v", {"a.L", "a.V"}), "unknown name 'v': did you mean 'a.V'?");
  EXPECT_EQ(text("ab", {"ax", "xy"}), "unknown name 'ab': did you mean 'ax'?");
  EXPECT_EQ(text("abc", {"axy"}), "unknown name 'abc'; see help");
}

}  // namespace rupture::testing
