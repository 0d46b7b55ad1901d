// NUMBERS, SECTION, PAINT and COMPARE by hand.
#include <gtest/gtest.h>

#include "panel_hand.h"

namespace erg::test {

using session::CellPlace;
using ui::make_compare_panel;
using ui::make_numbers_panel;
using ui::make_paint_panel;
using ui::make_section_panel;
using ui::TerrainTool;

namespace {

TEST(NumbersPanel, WithoutATerrainItLeadsToTheGallery) {
  PanelHand panel(make_numbers_panel());
  panel.hand.click("NUMBERS/GALLERY");
  EXPECT_EQ(panel.opened, std::vector<std::string>{"GALLERY"});
}

TEST(NumbersPanel, PlotsTheRunAndSavesItsDataAsCsv) {
  PanelHand panel(make_numbers_panel());
  panel.create();
  panel.app.runner().run(20);
  panel.app.runner().wait_until_still();
  panel.settle();
  EXPECT_TRUE(panel.hand.has("spread"));
  panel.hand.click("heights");
  panel.hand.click("SAVE HISTOGRAM");
  panel.hand.enter("SAVE HISTOGRAM/name", "spread");
  EXPECT_NE(read_bytes(panel.folder / "spread.csv").find("height"), std::string::npos);
}

TEST(SectionPanel, CutsBetweenTwoClickedPoints) {
  PanelHand panel(make_section_panel());
  panel.create();
  EXPECT_EQ(panel.tool, TerrainTool::camera);
  panel.hand.click("PICK TWO POINTS");
  EXPECT_EQ(panel.tool, TerrainTool::section);
  panel.click_terrain({2, 3});
  panel.click_terrain({22, 3});
  EXPECT_EQ(panel.tool, TerrainTool::camera) << "after two points the mouse turns the view again";
  ASSERT_TRUE(panel.hand.has("cut"));
  ASSERT_EQ(panel.marks.size(), 1u);
  EXPECT_EQ(panel.marks[0].points.size(), 2u);
  EXPECT_EQ(panel.marks[0].points[1][0], 22);

  panel.hand.click("SECTION/SAVE");
  panel.hand.enter("SAVE SECTION/name", "cut.csv");
  const std::string text = read_bytes(panel.folder / "cut.csv");
  EXPECT_GE(std::count(text.begin(), text.end(), '\n'), 21) << "a row a cell";

  panel.hand.click("CLEAR");
  EXPECT_FALSE(panel.hand.has("cut"));
  EXPECT_TRUE(panel.marks.empty());
}

std::int64_t mobile(PanelHand& panel) { return panel.app.now().runs.front().terrain->total_mobile(); }

TEST(PaintPanel, AStrokePutsSandDownAndIsUndoneExactly) {
  PanelHand panel(make_paint_panel());
  panel.create();
  const std::int64_t before = mobile(panel);
  panel.click_terrain({10, 10});
  panel.settle();
  EXPECT_EQ(mobile(panel), before) << "the brush was not taken";
  panel.hand.click("TAKE THE BRUSH");
  EXPECT_EQ(panel.tool, TerrainTool::paint);
  panel.click_terrain({10, 10});
  panel.settle();
  const std::int64_t after = mobile(panel);
  EXPECT_GT(after, before);
  EXPECT_EQ(panel.app.now().runs.front().mass_drift(), 0);
  panel.hand.click("UNDO");
  panel.settle();
  EXPECT_EQ(mobile(panel), before);
  panel.hand.click("REDO");
  panel.settle();
  EXPECT_EQ(mobile(panel), after);
}

/// How many slabs lie on a cell more than before.
std::int32_t put_on(const PanelHand& panel, const Terrain& before, CellPlace cell) {
  return panel.app.now().runs.front().terrain->mobile()(cell.x, cell.y) - before.mobile()(cell.x, cell.y);
}

TEST(PaintPanel, AStrokeHasNoGapsHoweverFastThePointerMoves) {
  PanelHand panel(make_paint_panel());
  panel.create();
  panel.hand.click("TAKE THE BRUSH");
  const Terrain before = *panel.app.now().runs.front().terrain;
  panel.pointer = {CellPlace{4, 12}, true, true};
  panel.hand.frames();
  panel.pointer = {CellPlace{28, 12}, false, true};
  panel.hand.frames();
  panel.pointer = {CellPlace{28, 12}, false, false};
  panel.settle();
  for (int x = 4; x <= 28; ++x) EXPECT_GT(put_on(panel, before, {x, 12}), 0) << x;
  EXPECT_EQ(panel.app.now().undo_count, 1u) << "one stroke";
}

TEST(PaintPanel, HoldingTheBrushStillPours) {
  PanelHand panel(make_paint_panel());
  panel.create();
  panel.hand.click("TAKE THE BRUSH");
  const Terrain before = *panel.app.now().runs.front().terrain;
  panel.click_terrain({10, 10});
  panel.settle();
  const std::int32_t once = put_on(panel, before, {10, 10});
  panel.pointer = {CellPlace{24, 12}, true, true};
  panel.hand.frames();
  panel.pointer = {CellPlace{24, 12}, false, true};
  panel.hand.frames(60);  // a second
  panel.pointer = {CellPlace{24, 12}, false, false};
  panel.settle();
  EXPECT_GE(put_on(panel, before, {24, 12}), 4 * once);
  EXPECT_EQ(panel.app.now().undo_count, 2u) << "a touch and a stroke";
}

TEST(PaintPanel, TheFirstTouchIsSeenAndItsAmountIsInMetres) {
  PanelHand panel(make_paint_panel());
  panel.create();
  panel.hand.click("TAKE THE BRUSH");
  const Terrain before = *panel.app.now().runs.front().terrain;
  panel.click_terrain({16, 12});
  panel.settle();
  const double metres = before.metres(put_on(panel, before, {16, 12}));
  EXPECT_GE(metres, 0.3 * before.cell_size()) << "a heap, not a film";
  panel.hand.enter("amount", std::to_string(before.metres(7)));
  panel.click_terrain({5, 5});
  panel.settle();
  EXPECT_EQ(put_on(panel, before, {5, 5}), 7);
}

TEST(PaintPanel, RockIsPutAndSandTaken) {
  PanelHand panel(make_paint_panel());
  panel.create();
  const std::int64_t sand = mobile(panel);
  panel.hand.click("TAKE THE BRUSH");
  panel.hand.click("PAINT/ROCK");
  panel.hand.enter("amount", std::to_string(panel.app.now().runs.front().terrain->metres(5)));
  panel.click_terrain({10, 10});
  panel.settle();
  const Terrain& terrain = *panel.app.now().runs.front().terrain;
  EXPECT_EQ(terrain.bedrock()(10, 10), 5);
  EXPECT_EQ(mobile(panel), sand);
  panel.hand.click("SAND");
  panel.hand.click("PAINT/TAKE");
  panel.click_terrain({20, 12});
  panel.settle();
  EXPECT_LT(mobile(panel), sand);
}

TEST(PaintPanel, PlantsArePutAndTakenWhereTheModelHasThem) {
  PanelHand panel(make_paint_panel());
  panel.create();
  EXPECT_FALSE(panel.hand.has("PAINT/GRASS"));
  panel.app.setup().choose_model("nield_baas");
  panel.app.create();
  panel.settle();
  const auto grass = [&] {
    return find_field(panel.app.now().runs.front().terrain->fields(), "grass")->values(10, 10);
  };
  ASSERT_EQ(grass(), 0);
  panel.hand.click("TAKE THE BRUSH");
  panel.hand.click("PAINT/GRASS");
  panel.hand.enter("PAINT/strength", "0.5");
  panel.click_terrain({10, 10});
  panel.settle();
  EXPECT_EQ(grass(), 0.5f);
  panel.hand.click("PAINT/TAKE");
  panel.click_terrain({10, 10});
  panel.settle();
  EXPECT_EQ(grass(), 0);
  panel.app.setup().choose_model("momiji");
  panel.app.create();
  panel.settle();
  panel.click_terrain({10, 10});
  panel.settle();
  EXPECT_EQ(panel.app.log().count(session::LogLevel::error), 0u) << "the brush has sand again";
}

TEST(ComparePanel, ACopyIsAddedChangedCreatedAndRemoved) {
  PanelHand panel(make_compare_panel());
  panel.create();
  panel.hand.click("ADD A COPY");
  ASSERT_EQ(panel.app.comparison().size(), 2u);
  EXPECT_EQ(panel.app.active(), 1u);
  panel.app.setup().set("parameters", "p_sand", 0.9);
  panel.hand.click("COMPARE/CREATE");
  panel.settle();
  ASSERT_EQ(panel.app.now().runs.size(), 2u);
  EXPECT_EQ(panel.app.now().runs[1].config->parameters.real("p_sand"), 0.9);
  panel.hand.click("EDIT RUN 1");
  EXPECT_EQ(panel.app.active(), 0u);
  panel.hand.click("remove 2");
  EXPECT_EQ(panel.app.comparison().size(), 1u);
  EXPECT_FALSE(panel.hand.place("remove 1").enabled);
}

TEST(SectionPanel, WhileACopyWaitsForCreateTheCutIsThatOfTheRunShown) {
  PanelHand panel(make_section_panel());
  panel.create();
  panel.app.runner().run(3);
  panel.app.runner().wait_until_still();
  panel.settle();
  panel.app.set_active(*panel.app.comparison().add_copy_of(0));
  panel.hand.click("PICK TWO POINTS");
  panel.click_terrain({2, 3});
  panel.click_terrain({22, 3});
  panel.hand.click("SECTION/SAVE");
  panel.hand.enter("SAVE SECTION/name", "cut.csv");
  EXPECT_EQ(panel.app.provenance().step, 3);
  EXPECT_EQ(panel.app.provenance().executor.find("none"), std::string::npos);
  panel.app.start_export(panel.folder / "run.checkpoint", "checkpoint");
  EXPECT_NE(panel.app.running_export(), nullptr);
}

TEST(ComparePanel, FourRunsAreTheMost) {
  PanelHand panel(make_compare_panel());
  panel.create();
  for (int copy = 0; copy < 3; ++copy) panel.hand.click("ADD A COPY");
  EXPECT_EQ(panel.app.comparison().size(), 4u);
  EXPECT_FALSE(panel.hand.place("ADD A COPY").enabled);
}

}  // namespace
}  // namespace erg::test
