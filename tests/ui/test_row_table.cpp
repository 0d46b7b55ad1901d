// A list of rows, by hand.
#include <gtest/gtest.h>

#include "harness.h"
#include "ui/widgets/row_table.h"

namespace erg::test {
namespace {

Parameter stones() {
  return {.key = "stones",
          .label = "stones",
          .default_value = RowList{},
          .minimum = 0,
          .maximum = 3,
          .columns = {{.key = "x", .label = "east", .unit = "cells", .default_value = 4.0, .minimum = 0, .maximum = 99},
                      {.key = "tall", .label = "tall", .default_value = false}},
          .row_name = "stone",
          .meaning = "Stones that lie on the sand."};
}

TEST(RowTable, RowsAreAddedChangedMovedAndRemoved) {
  const Parameter declared = stones();
  ParameterValue value = RowList{};
  const auto rows = [&]() -> const std::vector<ParameterValues>& { return std::get<RowList>(value).rows; };
  UiHarness hand([&] {
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({320, 600});
    ImGui::Begin("window");
    ui::parameter_row(declared, value);
    ImGui::End();
  });
  EXPECT_FALSE(hand.place("stones/REMOVE").enabled) << "there is none";
  EXPECT_FALSE(hand.place("stones/COPY").enabled);
  hand.click("stones/ADD");
  ASSERT_EQ(rows().size(), 1u);
  EXPECT_EQ(rows()[0].real("x"), 4);
  hand.enter("stones/east", "7");
  EXPECT_EQ(rows()[0].real("x"), 7);
  hand.click("stones/COPY");
  ASSERT_EQ(rows().size(), 2u);
  hand.enter("stones/east", "9");  // of the copy, which is chosen now
  EXPECT_EQ(rows()[0].real("x"), 7);
  EXPECT_EQ(rows()[1].real("x"), 9);
  hand.click("stones/up");
  EXPECT_EQ(rows()[0].real("x"), 9);
  hand.click("stones/ADD");
  EXPECT_FALSE(hand.place("stones/ADD").enabled) << "three are the most";
  hand.click("stones/stone 1");
  hand.click("stones/REMOVE");
  ASSERT_EQ(rows().size(), 2u);
  EXPECT_EQ(rows()[0].real("x"), 7);
  EXPECT_FALSE(check_value(declared, value, "")) << "whatever is done, the list is a right one";
}

}  // namespace
}  // namespace erg::test
