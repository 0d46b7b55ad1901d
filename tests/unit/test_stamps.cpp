// What executors and models keep of a terrain is told by its stamp: whatever is assigned, swapped or moved, and
// whenever, the next step starts from what the terrain then holds.
#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/stamp.h"
#include "models/slab/slab_step.h"
#include "sim/make_executor.h"
#include "small_runs.h"

namespace erg {

using models::move_slabs;
using sim::Config;
using sim::make_executor;
using sim::Simulation;

namespace {

using test::name_of;
using test::small_runs;

TEST(Stamp, IsNeverThatOfAnother) {
  std::set<std::uint64_t> seen{0};
  Stamp stamp;
  EXPECT_TRUE(seen.insert(stamp.value()).second);
  stamp.renew();
  EXPECT_TRUE(seen.insert(stamp.value()).second) << "changed";
  Stamp copy(stamp);
  EXPECT_TRUE(seen.insert(copy.value()).second) << "copied";
  copy = stamp;
  EXPECT_TRUE(seen.insert(copy.value()).second) << "assigned";
  const std::uint64_t before = stamp.value();
  Stamp moved(std::move(stamp));
  EXPECT_EQ(moved.value(), before) << "what is moved is the same still";
  EXPECT_TRUE(seen.insert(stamp.value()).second) << "what is left behind is not";
  copy = std::move(moved);
  EXPECT_EQ(copy.value(), before);
  EXPECT_TRUE(seen.insert(moved.value()).second);
}

TEST(Stamp, OfATerrainChangesWithItsLayersAndFieldsEachByItself) {
  Terrain terrain({4, 4}, 1, 1);
  const std::uint64_t ground = terrain.stamp();
  const std::uint64_t fields = terrain.fields_stamp();
  EXPECT_NE(ground, fields);
  terrain.edit_fields();
  EXPECT_EQ(terrain.stamp(), ground);
  EXPECT_NE(terrain.fields_stamp(), fields);
  terrain.edit_mobile();
  const std::uint64_t with_sand = terrain.stamp();
  EXPECT_NE(with_sand, ground);
  terrain.edit_bedrock();
  EXPECT_NE(terrain.stamp(), with_sand);
}

/// Fails unless three more steps do what they would do in a run that starts here.
void expect_goes_on_from(const Terrain& terrain, Simulation& run, const std::string& where) {
  Simulation fresh(run.config(), sim::RunState{terrain, run.step_count(), {}});
  for (int step = 0; step < 3; ++step) {
    run.step();
    fresh.step();
  }
  EXPECT_EQ(state_hash(run.terrain()), state_hash(fresh.terrain())) << where;
}

TEST(Stamp, WhateverIsAssignedToARunIsWhatItsNextStepSees) {
  using Change = std::function<void(Terrain & terrain, Terrain & other)>;
  const std::vector<std::pair<std::string, Change>> changes{
      {"copied", [](Terrain& terrain, Terrain& other) { terrain = other; }},
      {"moved", [](Terrain& terrain, Terrain& other) { terrain = std::move(other); }},
      {"swapped", [](Terrain& terrain, Terrain& other) { std::swap(terrain, other); }},
      {"copied there and back",
       [](Terrain& terrain, Terrain& other) {
         const Terrain kept = terrain;
         terrain = other;
         terrain = kept;
       }},
      {"swapped there and back",
       [](Terrain& terrain, Terrain& other) {
         std::swap(terrain, other);
         std::swap(terrain, other);
       }},
  };
  for (const Config& config : small_runs()) {
    for (const auto& [how, change] : changes) {
      // The other terrain has been edited so many times: whatever counts edits is the same once.
      for (int edits = 0; edits < 4; ++edits) {
        Simulation run(config);
        Terrain older = run.terrain();
        for (int k = 0; k < edits; ++k) {
          older.edit_mobile()(3, 3) += 2;
          older.edit_fields();
        }
        for (int step = 0; step < 2; ++step) run.step();
        Terrain& terrain = run.edit_terrain();
        change(terrain, older);
        run.book_edit();
        const Terrain now = terrain;
        expect_goes_on_from(now, run, name_of(config) + ", " + how + ", " + std::to_string(edits) + " edits");
      }
    }
  }
}

TEST(Stamp, ARunThatIsMovedBetweenStepsLosesNone) {
  for (const Config& config : small_runs()) {
    Simulation stays(config);
    Simulation moves(config);
    for (int step = 0; step < 4; ++step) {
      stays.step();
      moves.step();
      Simulation elsewhere(std::move(moves));
      moves = std::move(elsewhere);
    }
    EXPECT_EQ(state_hash(moves.terrain()), state_hash(stays.terrain())) << name_of(config);
    EXPECT_EQ(moves.terrain().total_mobile(), moves.terrain().ledger().expected()) << name_of(config);
  }
}

// The law may change under a cover that stays: what stands under it is made of both.
TEST(Stamp, OfACoverDoesNotHideAnotherReposeFromAnExecutor) {
  const auto hash = [](bool same_executor) {
    Terrain terrain({40, 30}, 1, 1);
    for (int x = 10; x < 20; ++x) terrain.edit_mobile()(x, 12) = 30;
    terrain.open_ledger();
    models::Cover cover{models::CoverField(terrain.extent(), 128)};
    models::SlabLaw law;
    law.cover = &cover;
    law.covered = {20, 28};
    auto executor = make_executor({.name = "cpu", .threads = 1});
    move_slabs(*executor, terrain, law, {270, 3}, {1, 0});
    if (!same_executor) {
      executor->sync_to_host(terrain);
      executor = make_executor({.name = "cpu", .threads = 1});
    }
    law.covered = {3, 4};
    move_slabs(*executor, terrain, law, {270, 3}, {1, 1});
    executor->sync_to_host(terrain);
    return state_hash(terrain);
  };
  EXPECT_EQ(hash(true), hash(false));
}

}  // namespace
}  // namespace erg
