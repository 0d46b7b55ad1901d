// How large the interface is made on which screen.
#include <gtest/gtest.h>

#include "ui/window/screen_scale.h"

namespace erg::test {

using ui::Monitor;
using ui::monitor_at;
using ui::suggested_scale;

namespace {

Monitor monitor(int width, int height, int millimetres) { return {0, 0, width, height, millimetres, false}; }

TEST(ScreenScale, TheDesktopsSettingCounts) {
  EXPECT_EQ(suggested_scale(96, monitor(3840, 2160, 340)), 1);
  EXPECT_EQ(suggested_scale(120, monitor(1920, 1080, 300)), 1.25);
  EXPECT_EQ(suggested_scale(192, monitor(1920, 1080, 300)), 2);
  EXPECT_EQ(suggested_scale(960, monitor(1920, 1080, 300)), 3) << "no larger";
}

TEST(ScreenScale, WithoutOneTheMonitorsPixelsAndTheirClosenessBothCount) {
  EXPECT_EQ(suggested_scale(0, monitor(1920, 1080, 300)), 1);
  EXPECT_EQ(suggested_scale(0, monitor(1920, 1080, 174)), 1) << "14 inches, 157 dots an inch";
  EXPECT_EQ(suggested_scale(0, monitor(3840, 2160, 174)), 2) << "14 inches, 315 dots an inch";
  EXPECT_EQ(suggested_scale(0, monitor(3840, 2160, 570)), 1) << "a screen on the wall, 96 dots an inch";
  EXPECT_EQ(suggested_scale(0, monitor(3840, 2160, 0)), 2) << "it does not say how large it is";
  EXPECT_EQ(suggested_scale(0, monitor(1280, 720, 0)), 1);
}

TEST(ScreenScale, OfSeveralMonitorsTheOneUnderThePointerCounts) {
  const std::vector<Monitor> two{{0, 0, 1920, 1080, 300, false}, {0, 1080, 3840, 2160, 340, true}};
  EXPECT_EQ(monitor_at(two, 100, 100).height, 1080);
  EXPECT_EQ(monitor_at(two, 100, 1500).height, 2160);
  EXPECT_EQ(monitor_at(two, 3000, 100).height, 2160) << "beside both: the primary one";
}

}  // namespace
}  // namespace erg::test
