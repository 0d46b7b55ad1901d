// TEMPERATURE and the snow of WIND by hand; what the setup received is checked.
#include <gtest/gtest.h>

#include "panel_hand.h"

namespace erg::test {

using forcing::interval_columns;
using ui::make_temperature_panel;
using ui::make_wind_panel;

namespace {

TEST(TemperaturePanel, IsWantedForSnowOnly) {
  PanelHand panel(make_wind_panel());
  const auto temperature = make_temperature_panel();
  const ui::PanelContext context{panel.app, {}, ui::TerrainTool::camera, {}, {}, {}, {}, {}, {}};
  EXPECT_FALSE(temperature->wanted(context));
  panel.app.setup().choose_material(Material::snow);
  EXPECT_TRUE(temperature->wanted(context));
}

TEST(TemperaturePanel, EndsAreTypedAndTheCurveBetweenThemIsBent) {
  PanelHand panel(make_temperature_panel());
  panel.app.setup().choose_material(Material::snow);
  panel.hand.frames(2);
  EXPECT_FALSE(panel.hand.has("TEMPERATURE/curve/box"));  // nothing to bend while both ends are alike
  panel.hand.enter("TEMPERATURE/at the start", "-20");
  panel.hand.enter("TEMPERATURE/at the end", "-5");
  const forcing::Course& now = panel.app.setup().config().weather.temperature;
  EXPECT_EQ(now.first, -20);
  EXPECT_EQ(now.last, -5);
  const ui::WidgetPlace box = panel.hand.place("curve/box");
  panel.hand.drag(panel.hand.place("curve/first").middle(), {box.high.x, box.high.y});
  EXPECT_NEAR(now.curve.first.x, 1, 0.01);
  EXPECT_NEAR(now.curve.first.y, 0, 0.01);
}

TEST(WindPanel, SnowFallsInASeasonOfAModelThatLetsIt) {
  PanelHand panel(make_wind_panel());
  for (const char* model : {"momiji", "snow_packing"}) {
    panel.app.setup().choose_model(model);
    panel.hand.frames(2);
    EXPECT_FALSE(panel.hand.has("WIND/" + interval_columns().find("snowfall")->label)) << model;
  }
  panel.app.setup().choose_model("snow_sintering");
  panel.hand.frames(2);
  panel.hand.enter("WIND/" + interval_columns().find("snowfall")->label, "3");
  EXPECT_EQ(panel.app.setup().config().wind.intervals.front().snowfall, 3);
}

}  // namespace
}  // namespace erg::test
