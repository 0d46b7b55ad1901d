#include "core/parameters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "message.h"

namespace erg {
namespace {

Parameter chance() {
  return {
      .key = "p_sand", .label = "Deposition", .default_value = 0.6, .minimum = 0, .maximum = 1, .meaning = "Chance."};
}
Parameter steps() {
  return {.key = "steps",
          .label = "Steps",
          .default_value = 1000,
          .minimum = 0,
          .maximum = 1'000'000'000,
          .meaning = "Steps."};
}
Parameter neighbours() {
  return {.key = "neighbours",
          .label = "Neighbours",
          .default_value = "4",
          .choices = {"4", "8"},
          .meaning = "Where sand slides."};
}
Parameter boundary() {
  return {.key = "boundary",
          .label = "Boundary",
          .default_value = "torus",
          .choices = {"torus", "open"},
          .meaning = "Edges."};
}
Parameter forced() { return {.key = "forced", .label = "Forced", .default_value = false, .meaning = "Poll on."}; }

std::string problem(const Parameter& parameter, const ParameterValue& value) {
  const auto mistake = check_value(parameter, value, "a.json:3");
  return mistake ? mistake->text() : "fine";
}

TEST(Parameters, RangesAreClosed) {
  EXPECT_EQ(problem(chance(), 0.0), "fine");
  EXPECT_EQ(problem(chance(), 1.0), "fine");
  EXPECT_EQ(problem(chance(), std::nextafter(1.0, 2.0)), "a.json:3: p_sand is 1.0000000000000002; expected 0 to 1");
  EXPECT_EQ(problem(chance(), -0.1), "a.json:3: p_sand is -0.1; expected 0 to 1");
  EXPECT_EQ(problem(steps(), std::int64_t{1'000'000'000}), "fine");
  EXPECT_EQ(problem(steps(), std::int64_t{1'000'000'001}),
            "a.json:3: steps is 1000000001; expected a whole number, 0 to 1000000000");
}

TEST(Parameters, NumbersThatAreNoneAreRefused) {
  EXPECT_EQ(problem(chance(), std::nan("")), "a.json:3: p_sand is nan; expected 0 to 1");
  EXPECT_EQ(problem(chance(), std::numeric_limits<double>::infinity()), "a.json:3: p_sand is inf; expected 0 to 1");
  EXPECT_EQ(problem(steps(), std::nan("")), "a.json:3: steps is nan; expected a whole number, 0 to 1000000000");
  EXPECT_EQ(problem(steps(), 1e300), "a.json:3: steps is 1e+300; expected a whole number, 0 to 1000000000");
}

TEST(Parameters, KindsDoNotMix) {
  EXPECT_EQ(problem(chance(), std::string("much")), "a.json:3: p_sand is \"much\"; expected 0 to 1");
  EXPECT_EQ(problem(chance(), true), "a.json:3: p_sand is true; expected 0 to 1");
  EXPECT_EQ(problem(forced(), std::int64_t{1}), "a.json:3: forced is 1; expected true or false");
  EXPECT_EQ(problem(boundary(), 2.0), "a.json:3: boundary is 2; expected torus, open");
  EXPECT_EQ(problem(steps(), 1.5), "a.json:3: steps is 1.5; expected a whole number, 0 to 1000000000");
  EXPECT_EQ(problem(Parameter{.key = "image", .label = "Picture", .default_value = "", .meaning = "Heights."}, false),
            "a.json:3: image is false; expected the path of a file");
}

TEST(Parameters, WholeNumbersServeRealsAndTheOtherWayRound) {
  ParameterValues values({chance(), steps()});
  values.set("p_sand", std::int64_t{1});
  EXPECT_EQ(values.real("p_sand"), 1.0);
  values.set("steps", 250.0);
  EXPECT_EQ(values.integer("steps"), 250);
}

TEST(Parameters, UnknownChoicesAreCorrected) {
  EXPECT_EQ(problem(boundary(), std::string("toruss")),
            "a.json:3: unknown boundary \"toruss\"; did you mean \"torus\"?");
  EXPECT_EQ(problem(boundary(), std::string("periodic")),
            "a.json:3: unknown boundary \"periodic\"; expected one of torus, open");
}

TEST(Parameters, MessagesStayOnOneLine) {
  const std::string nasty = "a\nb\x1b" + std::string(100, 'x');
  EXPECT_EQ(quote(nasty), "\"a?b?" + std::string(56, 'x') + "...\"");
  // A cut never splits a character: 59 letters, then one of two bytes.
  EXPECT_EQ(quote(std::string(59, 'x') + "\u00e9y"), "\"" + std::string(59, 'x') + "...\"");
}

TEST(Parameters, ValuesAreReadAsTyped) {
  EXPECT_EQ(std::get<double>(parse_value(chance(), "0.25", "x")), 0.25);
  EXPECT_EQ(std::get<double>(parse_value(chance(), "1", "x")), 1.0);
  EXPECT_EQ(std::get<double>(parse_value(chance(), "1e-3", "x")), 0.001);
  EXPECT_EQ(std::get<std::int64_t>(parse_value(steps(), "+20", "x")), 20);
  EXPECT_EQ(std::get<std::int64_t>(parse_value(steps(), "1e6", "x")), 1'000'000);
  EXPECT_EQ(std::get<bool>(parse_value(forced(), "yes", "x")), true);
  EXPECT_EQ(std::get<bool>(parse_value(forced(), "off", "x")), false);
  EXPECT_EQ(std::get<std::string>(parse_value(neighbours(), "8", "x")), "8");
}

TEST(Parameters, WhatCannotBeReadIsRefused) {
  for (const char* text : {"", " ", "0.5x", "0.5 ", "0x1", "--1", "+-1", "1e999"}) {
    EXPECT_EQ(message([&] { parse_value(chance(), text, "--set"); }),
              std::string("--set: p_sand is \"") + text + "\"; expected 0 to 1");
  }
  EXPECT_EQ(message([] { parse_value(chance(), "nan", "--set"); }), "--set: p_sand is nan; expected 0 to 1");
  EXPECT_EQ(message([] { parse_value(chance(), "-inf", "--set"); }), "--set: p_sand is -inf; expected 0 to 1");
  EXPECT_EQ(message([] { parse_value(forced(), "1", "--set"); }), "--set: forced is \"1\"; expected true or false");
}

TEST(Parameters, TextOfAValueReadsBackToIt) {
  for (const double number : {1.0 / 3, 0.1, 1e-300, 1e300, 33.7, 5.0, -0.0, 0x1.fffffffffffffp-2}) {
    const Parameter any{
        .key = "x", .label = "X", .default_value = 0.0, .minimum = -1e308, .maximum = 1e308, .meaning = "Any."};
    EXPECT_EQ(std::get<double>(parse_value(any, value_text(number), "x")), number) << value_text(number);
  }
  EXPECT_EQ(value_text(1.0 / 3), "0.3333333333333333");
  EXPECT_EQ(value_text(5.0), "5");
  EXPECT_EQ(value_text(std::int64_t{-7}), "-7");
  EXPECT_EQ(value_text(true), "true");
  EXPECT_EQ(value_text(std::string("flat")), "flat");
}

TEST(Parameters, StartAtTheirDefaults) {
  ParameterValues values({chance(), steps(), boundary(), forced()});
  EXPECT_EQ(values.real("p_sand"), 0.6);
  EXPECT_EQ(values.integer("steps"), 1000);
  EXPECT_EQ(values.text("boundary"), "torus");
  EXPECT_FALSE(values.boolean("forced"));
  for (const Parameter& parameter : values.declared()) EXPECT_TRUE(values.is_default(parameter.key));
  values.set("p_sand", 0.5);
  EXPECT_FALSE(values.is_default("p_sand"));
  values.set("p_sand", 0.6);
  EXPECT_TRUE(values.is_default("p_sand"));
}

TEST(Parameters, TheDefaultsTypeIsTheKind) {
  EXPECT_EQ(chance().kind(), ParameterKind::real);
  EXPECT_EQ(steps().kind(), ParameterKind::integer);
  EXPECT_EQ(forced().kind(), ParameterKind::boolean);
  EXPECT_EQ(boundary().kind(), ParameterKind::choice);
  EXPECT_EQ((Parameter{.key = "image", .default_value = ""}.kind()), ParameterKind::path);
  EXPECT_EQ((Parameter{.key = "growth", .default_value = PiecewiseLinear{{{0, 0}, {1, 1}}}}.kind()),
            ParameterKind::curve);
}

TEST(Parameters, CopiesOfValuesShareTheDeclarations) {
  const ParameterValues values({chance(), steps()});
  ParameterValues copy = values;
  copy.set("p_sand", 0.1);
  EXPECT_EQ(&copy.declared(), &values.declared());
  EXPECT_EQ(&ParameterValues(values.declarations()).declared(), &values.declared());
  EXPECT_NE(&ParameterValues({chance(), steps()}).declared(), &values.declared());
}

TEST(Parameters, ARefusedValueChangesNothing) {
  ParameterValues values({chance(), steps()});
  const ParameterValues before = values;
  EXPECT_EQ(message([&] { values.set("p_sand", 2.0); }), "p_sand is 2; expected 0 to 1");
  EXPECT_EQ(message([&] { values.set("p_snad", 0.5); }), "unknown key \"p_snad\"; did you mean \"p_sand\"?");
  EXPECT_EQ(message([&] { values.set("wavelength", 0.5); }),
            "unknown key \"wavelength\"; expected one of p_sand, steps");
  EXPECT_EQ(values, before);
}

TEST(Parameters, MinusZeroIsKeptAsZero) {
  ParameterValues values(
      {{.key = "x", .label = "X", .default_value = 1.0, .minimum = -1, .maximum = 1, .meaning = "Any."}});
  values.set("x", -0.0);
  EXPECT_FALSE(std::signbit(values.real("x")));
}

TEST(Parameters, AChoiceOfNumbersReadsAsANumber) {
  ParameterValues values({neighbours(), boundary()});
  EXPECT_EQ(values.integer("neighbours"), 4);
  values.set("neighbours", std::string("8"));
  EXPECT_EQ(values.integer("neighbours"), 8);
  EXPECT_THROW(values.integer("boundary"), std::logic_error);
}

TEST(Parameters, AskingForAnUndeclaredKeyIsABug) {
  const ParameterValues values({chance()});
  EXPECT_THROW(values.real("p_bare"), std::logic_error);
  EXPECT_EQ(values.find("p_bare"), nullptr);
}

TEST(Parameters, SayWhatTheyAccept) {
  EXPECT_EQ(accepted_text(chance()), "0 to 1");
  EXPECT_EQ(accepted_text(steps()), "a whole number, 0 to 1000000000");
  EXPECT_EQ(accepted_text(boundary()), "torus, open");
  EXPECT_EQ(accepted_text(forced()), "true or false");
  // Bounds of whole numbers are never written with an exponent.
  EXPECT_EQ(accepted_text(Parameter{.key = "seed",
                                    .label = "Seed",
                                    .default_value = 0,
                                    .minimum = 0,
                                    .maximum = std::int64_t{1} << 53,
                                    .meaning = "Seed."}),
            "a whole number, 0 to 9007199254740992");
}

}  // namespace
}  // namespace erg
