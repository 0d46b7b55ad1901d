// SETUP and WIND by hand; what the setup received is checked.
#include <gtest/gtest.h>

#include <chrono>
#include <set>
#include <thread>

#include "models/model.h"
#include "panel_hand.h"
#include "sim/config.h"

namespace erg::test {

using forcing::interval_columns;
using forcing::WindInterval;
using forcing::WindSchedule;
using models::ModelType;
using session::SetupRow;
using ui::make_setup_panel;
using ui::make_wind_panel;

namespace {

TEST(SetupPanel, EveryDeclaredValueOfTheModelHasItsRow) {
  PanelHand panel(make_setup_panel());
  panel.hand.move({160, 300});
  for (const ModelType* type : session::Setup::models_of(Material::sand)) {
    panel.app.setup().choose_model(type->info.key);
    panel.hand.scroll(1000);
    std::set<std::string> seen;  // on the way down
    for (int page = 0; page < 20; ++page) {
      for (const SetupRow& row : panel.app.setup().rows("parameters")) {
        if (panel.hand.has("SETUP/parameters/" + row.parameter->label)) seen.insert(row.parameter->key);
      }
      panel.hand.scroll(-3);
    }
    for (const SetupRow& row : panel.app.setup().rows("parameters")) {
      EXPECT_EQ(seen.contains(row.parameter->key), row.relevant) << type->info.key << ": " << row.parameter->label;
    }
  }
}

TEST(SetupPanel, ChoosesTheModelAndShowsOnlyItsValues) {
  PanelHand panel(make_setup_panel());
  const ModelType& wanted = models::find_model("werner");
  panel.hand.click("SETUP/model");
  panel.hand.click("model=" + wanted.info.title);
  EXPECT_EQ(panel.app.setup().config().model, "werner");
}

TEST(SetupPanel, ValuesAreTypedResetAndAllReset) {
  PanelHand panel(make_setup_panel());
  const Parameter& nx = *panel.app.setup().config().grid.find("nx");
  const std::string row = "SETUP/grid/" + nx.label;
  panel.hand.enter(row, "96");
  EXPECT_EQ(panel.app.setup().config().grid.integer("nx"), 96);
  panel.hand.click(row + " reset");
  EXPECT_TRUE(panel.app.setup().config().grid.is_default("nx"));
  panel.hand.enter(row, "96");
  panel.hand.click("RESET DEFAULT");
  EXPECT_EQ(panel.app.setup().config(), sim::Config(panel.app.setup().config().model));
}

TEST(SetupPanel, CreateMakesTheTerrain) {
  PanelHand panel(make_setup_panel());
  panel.app.setup().replace(small_config());
  panel.hand.frames();
  EXPECT_TRUE(panel.app.create_needed());
  panel.hand.click("CREATE");
  panel.settle();
  ASSERT_TRUE(panel.app.now().has_runs());
  EXPECT_EQ(panel.app.now().runs.front().terrain->nx(), 32);
  EXPECT_FALSE(panel.app.create_needed());
}

TEST(SetupPanel, WhatWillCrawlSaysSoAndMovesNoRow) {
  PanelHand panel(make_setup_panel());
  panel.app.setup().choose_model("grains");
  panel.app.setup().set("run", "executor", std::string("serial"));
  panel.hand.frames(2);
  const float before = panel.hand.place("SETUP/model").low.y;
  EXPECT_FALSE(panel.hand.has("SETUP/cost"));
  panel.app.setup().set("grid", "nx", std::int64_t{4096});
  panel.app.setup().set("grid", "ny", std::int64_t{4096});
  for (int wait = 0; wait < 3000 && !panel.hand.has("SETUP/cost"); ++wait) {  // 64 x 64 of its cells are measured
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    panel.hand.frames();
  }
  ASSERT_TRUE(panel.hand.has("SETUP/cost"));
  const ui::WidgetPlace cost = panel.hand.place("SETUP/cost");
  EXPECT_LE(cost.high.y - cost.low.y, 1.5f * ImGui::GetTextLineHeight()) << "one line";
  EXPECT_EQ(panel.hand.place("SETUP/model").low.y, before);
}

TEST(SetupPanel, AFreshSeedIsDrawnWithEachCreate) {
  PanelHand panel(make_setup_panel());
  panel.create();
  panel.hand.click("fresh seed");
  EXPECT_TRUE(panel.app.setup().fresh_seed());
  panel.hand.click("CREATE");
  panel.settle();
  const std::int64_t first = panel.app.now().runs.front().config->run.integer("seed");
  panel.hand.click("CREATE");
  panel.settle();
  EXPECT_NE(panel.app.now().runs.front().config->run.integer("seed"), first);
}

TEST(SetupPanel, ASceneOfAPictureAsksForItAndTakesItFromTheBrowser) {
  PanelHand panel(make_setup_panel(), [](const TemporaryFolder& folder) { write_bytes(folder / "hills.png", "x"); });
  panel.app.setup().set("scene", "kind", std::string("image"));
  panel.hand.frames(2);
  EXPECT_FALSE(panel.hand.place("SETUP/CREATE").enabled) << "there is no picture yet";
  panel.hand.click("scene/BROWSE");
  panel.hand.click("files/hills.png");
  panel.hand.click("CHOOSE A PICTURE/CHOOSE");
  EXPECT_EQ(panel.app.setup().config().scene.text("image"), panel.folder / "hills.png");
}

TEST(SetupPanel, AMapOfPlantsIsChosenLikeAPictureOfTheTerrain) {
  PanelHand panel(make_setup_panel(), [](const TemporaryFolder& folder) { write_bytes(folder / "dunes.png", "x"); });
  panel.app.setup().choose_model("nield_baas");
  panel.app.setup().set("parameters", "vegetation", std::string("image"));
  panel.hand.frames(2);
  panel.hand.click("parameters/BROWSE");
  panel.hand.click("files/dunes.png");
  panel.hand.click("CHOOSE A PICTURE/CHOOSE");
  EXPECT_EQ(panel.app.setup().config().parameters.text("vegetation_image"), panel.folder / "dunes.png");
  EXPECT_EQ(panel.app.setup().config().scene.text("image"), "");
}

TEST(WindPanel, AConstantWindIsTurnedAndStrengthened) {
  PanelHand panel(make_wind_panel());
  panel.hand.drag("WIND/dial", {0.1f, 0.5f}, {0.5f, 0.05f});
  panel.hand.enter("WIND/strength", "7");
  const WindSchedule& wind = panel.app.setup().config().wind;
  EXPECT_TRUE(wind.is_constant());
  EXPECT_EQ(wind.intervals.front().bearing, 0);
  EXPECT_EQ(wind.intervals.front().first, 7);
  EXPECT_EQ(wind.intervals.front().last, 7);
}

TEST(WindPanel, ASpreadIsSetTakenBackAndSwitchedOff) {
  PanelHand panel(make_wind_panel());
  const auto season = [&]() -> const WindInterval& { return panel.app.setup().config().wind.intervals.front(); };
  EXPECT_EQ(season().spread, models::natural_spread);
  panel.hand.enter("WIND/" + interval_columns().find("spread")->label, "25");
  panel.hand.enter("WIND/" + interval_columns().find("hold")->label, "9");
  EXPECT_EQ(season().spread, 25);
  EXPECT_EQ(season().hold, 9);
  panel.hand.enter("WIND/" + interval_columns().find("spread")->label, "0");
  panel.hand.frames(2);
  EXPECT_EQ(season().spread, 0);
  EXPECT_FALSE(panel.hand.has("WIND/" + interval_columns().find("hold")->label)) << "nothing is held without a spread";
}

TEST(WindPanel, SeasonsAreAddedCopiedMovedAndRemoved) {
  PanelHand panel(make_wind_panel());
  const auto wind = [&]() -> const WindSchedule& { return panel.app.setup().config().wind; };
  panel.hand.click("SEASONS");
  panel.hand.click("ADD");
  ASSERT_EQ(wind().intervals.size(), 2u);
  panel.hand.enter("WIND/bearing", "NE");
  EXPECT_EQ(wind().intervals[1].bearing, 45);
  panel.hand.enter("first strength", "3");
  panel.hand.enter("last strength", "9");
  panel.hand.enter("length", "80");
  EXPECT_EQ(wind().intervals[1].first, 3);
  EXPECT_EQ(wind().intervals[1].last, 9);
  EXPECT_EQ(wind().intervals[1].steps, 80);
  panel.hand.click("WIND/COPY");
  ASSERT_EQ(wind().intervals.size(), 3u);
  EXPECT_EQ(wind().intervals[2], wind().intervals[1]);
  panel.hand.click("WIND/up");
  panel.hand.click("WIND/up");
  EXPECT_EQ(wind().intervals[0].bearing, 45);
  EXPECT_FALSE(panel.hand.place("WIND/up").enabled);
  panel.hand.click("WIND/down");
  EXPECT_EQ(wind().intervals[1].bearing, 45);
  panel.hand.click("season 1");
  panel.hand.click("WIND/REMOVE");
  EXPECT_EQ(wind().intervals.size(), 2u);
  panel.hand.click("WIND/REMOVE");
  EXPECT_EQ(wind().intervals.size(), 1u);
  EXPECT_FALSE(panel.hand.place("WIND/REMOVE").enabled) << "one season stays";
}

TEST(WindPanel, TheStrengthCurveIsBentAndReset) {
  PanelHand panel(make_wind_panel());
  panel.hand.click("SEASONS");
  panel.hand.enter("length", "100");
  panel.hand.enter("last strength", "9");
  const ui::WidgetPlace box = panel.hand.place("curve/box");
  panel.hand.drag(panel.hand.place("curve/first").middle(), {box.high.x, box.high.y});
  EXPECT_NEAR(panel.app.setup().config().wind.intervals[0].curve.first.x, 1, 0.01);
  EXPECT_NEAR(panel.app.setup().config().wind.intervals[0].curve.first.y, 0, 0.01);
  panel.hand.click("curve/RESET");
  EXPECT_EQ(panel.app.setup().config().wind.intervals[0].curve, BezierCurve{});
}

TEST(WindPanel, ConstantAndBackLosesNoSeason) {
  PanelHand panel(make_wind_panel());
  panel.hand.click("SEASONS");
  panel.hand.click("ADD");
  panel.hand.enter("WIND/bearing", "NE");
  const std::vector<WindInterval> before = panel.app.setup().config().wind.intervals;
  panel.hand.click("CONSTANT");
  EXPECT_TRUE(panel.app.setup().config().wind.is_constant());
  EXPECT_EQ(panel.app.setup().config().wind.intervals.front().bearing, 45);
  panel.hand.click("SEASONS");
  EXPECT_EQ(panel.app.setup().config().wind.intervals, before);
}

}  // namespace
}  // namespace erg::test
