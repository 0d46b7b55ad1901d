#include "picture/palette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/errors.h"

namespace erg {

using picture::Colour;
using picture::find_palette;
using picture::Palette;

namespace {

TEST(Palette, RunsFromItsFirstPointToItsLast) {
  for (const std::string& name : picture::palette_names()) {
    const Palette& palette = find_palette(name);
    ASSERT_GE(palette.points.size(), 2u) << palette.name;
    EXPECT_EQ(palette.at(0), palette.points.front()) << palette.name;
    EXPECT_EQ(palette.at(1), palette.points.back()) << palette.name;
    EXPECT_EQ(palette.at(-3), palette.points.front()) << palette.name;
    EXPECT_EQ(palette.at(7), palette.points.back()) << palette.name;
    EXPECT_EQ(palette.at(std::numeric_limits<double>::quiet_NaN()), palette.points.front()) << palette.name;
  }
}

TEST(Palette, IsLinearBetweenPoints) {
  const Colour middle = find_palette("grey").at(0.25);
  EXPECT_FLOAT_EQ(middle.red, 0.25f);
  EXPECT_FLOAT_EQ(middle.blue, 0.25f);
}

TEST(Palette, RdYlGnIsRedAbove) {
  EXPECT_GT(find_palette("RdYlGn").at(1).red, find_palette("RdYlGn").at(1).green);
  EXPECT_GT(find_palette("RdYlGn").at(0).green, find_palette("RdYlGn").at(0).red);
}

// Ordered palettes grow lighter all the way, so that they read in grey too.
TEST(Palette, OrderedOnesGrowLighter) {
  for (const char* name : {"sand", "cividis", "batlow", "grey"}) {
    double last = -1;
    for (int step = 0; step <= 20; ++step) {
      const Colour c = find_palette(name).at(step / 20.0);
      const double lightness =
          0.2126 * std::pow(c.red, 2.2) + 0.7152 * std::pow(c.green, 2.2) + 0.0722 * std::pow(c.blue, 2.2);
      EXPECT_GT(lightness, last) << name << " at " << step / 20.0;
      last = lightness;
    }
  }
}

TEST(Palette, AnUnknownNameGetsTheNearest) {
  try {
    find_palette("cividus");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("cividis"), std::string::npos);
  }
}

}  // namespace
}  // namespace erg
