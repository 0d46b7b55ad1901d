// The model of docs/add-a-model.md. Joined to the catalogue, it is held to the laws that all models keep; here is what
// is particular to it.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/memory.h"
#include "water_table.h"
#include "world.h"

namespace erg::test {

using models::add_model;
using models::catalogue;
using models::find_model;
using sim::Config;
using sim::memory_of_run;

namespace {

// Before the laws ask the catalogue for the models that they loop over.
const bool joined = (add_model(water_table()), true);

std::int32_t lowest_after(const std::string& model, const Machine& machine) {
  // One poll a cell and no slides: nothing but the wind lowers a cell, by one slab a step.
  const World world{.model = model,
                    .settings = {{"polling", std::string("nonrepeated")},
                                 {"repose_angle", 80.0},
                                 {"slab_height", 0.5},
                                 {"water_table", 1.5},
                                 {"fringe", 0.0}},
                    .sand = 6};
  Terrain terrain = world.strewn();
  Grid<std::int32_t>& mobile = terrain.edit_mobile();
  for (std::int32_t& slabs : mobile.cells()) slabs = std::max(slabs, 4);
  terrain.open_ledger();
  world.run(terrain, machine.options, 40);
  return *std::ranges::min_element(terrain.mobile().cells());
}

// What a model declares of its memory is what a run is reckoned with.
TEST(WaterTable, SaysWhatItsRunsKeepOfACell) {
  const Config water("water_table");
  const Config plain("werner");
  const auto cells = static_cast<std::uint64_t>(plain.grid.integer("nx") * plain.grid.integer("ny"));
  EXPECT_EQ(memory_of_run(water) - memory_of_run(plain), cells * find_model("water_table").working_bytes);
  EXPECT_GT(find_model("water_table").working_bytes, 0);
}

TEST(WaterTable, IsTheFloorOfTheWindsWork) {
  ASSERT_TRUE(joined);
  for (const Machine& machine : machines()) {
    EXPECT_EQ(lowest_after("water_table", machine), 3) << machine.name;  // 1.5 m of slabs of 0.5 m
    EXPECT_LT(lowest_after("werner", machine), 3) << machine.name;
  }
}

TEST(Catalogue, TakesNoSecondModelOfTheSameKey) {
  const std::size_t before = catalogue().size();
  EXPECT_THROW(add_model(water_table()), InputError);
  EXPECT_THROW(add_model(find_model("werner")), InputError);
  EXPECT_EQ(catalogue().size(), before);
}

}  // namespace
}  // namespace erg::test
