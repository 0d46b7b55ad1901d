// Axes and plots.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "in_a_column.h"
#include "ui/widgets/plot.h"

namespace erg::test {

using ui::AxisRange;
using ui::draw_plot;
using ui::figure_text;
using ui::line_colour;
using ui::PlotLine;
using ui::round_range;
using ui::round_ticks;

namespace {

std::vector<std::string> tick_texts(AxisRange range, int most) {
  const ui::Ticks ticks = round_ticks(range, most);
  std::vector<std::string> texts;
  for (int tick = 0; tick < ticks.count; ++tick) texts.push_back(ui::tick_text(ticks.at(tick), ticks.step));
  return texts;
}

using Texts = std::vector<std::string>;

TEST(AxisTicks, AreRoundNumbersWithinTheRange) {
  EXPECT_EQ(tick_texts({0, 1}, 6), (Texts{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(tick_texts({0, 1500}, 4), (Texts{"0", "500", "1000", "1500"}));
  EXPECT_EQ(tick_texts({-3, 12}, 5), (Texts{"0", "5", "10"}));
  EXPECT_EQ(tick_texts({0.31, 0.34}, 4), (Texts{"0.31", "0.32", "0.33", "0.34"}));
  EXPECT_EQ(tick_texts({0, 40000}, 3), (Texts{"0", "20 000", "40 000"}));
  EXPECT_TRUE(tick_texts({2, 2}, 4).empty());
  EXPECT_TRUE(tick_texts({0, std::numeric_limits<double>::infinity()}, 4).empty());
}

TEST(AxisTicks, NeverMoreThanAskedFor) {
  for (double high = 0.013; high < 1e7; high *= 1.7) {
    for (int most = 2; most < 9; ++most) EXPECT_LE(round_ticks({0, high}, most).count, most) << high;
  }
}

TEST(AxisTicks, RoundRangesHoldTheirValues) {
  const AxisRange range = round_range({0.7, 23.2}, 5);
  EXPECT_DOUBLE_EQ(range.low, 0);
  EXPECT_DOUBLE_EQ(range.high, 30);
  EXPECT_LT(round_range({4, 4}, 5).low, 4) << "a constant lies in the middle";
  EXPECT_GT(round_range({4, 4}, 5).high, 4);
}

TEST(Figures, ReadAsPeopleWriteThem) {
  EXPECT_EQ(figure_text(0), "0");
  EXPECT_EQ(figure_text(270), "270");
  EXPECT_EQ(figure_text(22.5), "22.5");
  EXPECT_EQ(figure_text(1.0 / 3), "0.333");
  EXPECT_EQ(figure_text(-0.5), "-0.5");
  EXPECT_EQ(figure_text(123456), "123 456");
  EXPECT_EQ(figure_text(2.5e12), "2.5e+12");
  EXPECT_EQ(figure_text(std::nan("")), "-");
}

TEST(Plot, TellsTheValueUnderTheMouse) {
  const std::vector<double> x{0, 50, 100};
  const std::vector<double> y{1, 3, std::nan("")};
  std::optional<double> under_mouse;
  UiHarness hand = in_a_column([&] {
    const PlotLine line{"height", x, y, line_colour(0)};
    under_mouse = draw_plot("plot", {&line, 1}, {.x_label = "step", .y_label = "height, m"});
  });
  EXPECT_FALSE(under_mouse);
  const ui::WidgetPlace box = hand.place("plot");
  hand.move({box.low.x + 0.25f * (box.high.x - box.low.x), box.middle().y});
  hand.frames();
  ASSERT_TRUE(under_mouse);
  EXPECT_NEAR(*under_mouse, 25, 0.5);
}

TEST(Plot, AThousandPointsCostNoMoreThanTheColumnsOfPixels) {
  std::vector<double> x;
  std::vector<double> y;
  for (int i = 0; i < 100000; ++i) {
    x.push_back(i);
    y.push_back(std::sin(i));
  }
  UiHarness hand = in_a_column([&] {
    const PlotLine line{"", x, y, line_colour(0)};
    draw_plot("plot", {&line, 1}, {});
  });
  EXPECT_LT(ImGui::GetDrawData()->TotalVtxCount, 12000) << "ImGui counts vertices in 16 bits";
}

TEST(Plot, EmptyPlotsAreDrawnToo) {
  UiHarness hand = in_a_column([&] {
    draw_plot("plot", {}, {.x_label = "step", .y_label = "height"});
    ui::draw_histogram("bars", {}, {0, 90}, {.x_label = "slope"});
  });
  EXPECT_TRUE(hand.has("plot"));
  EXPECT_TRUE(hand.has("bars"));
}

}  // namespace
}  // namespace erg::test
