// What holds for single grains: their flight, their bounce, and the ripples that they make.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/migration.h"
#include "analysis/morphometry.h"
#include "analysis/spectrum.h"
#include "core/units.h"
#include "models/grain_law.h"
#include "models/grains.h"
#include "wind/bearing.h"
#include "wind/wind_frame.h"
#include "world.h"

namespace erg::test {
namespace {

ParameterValues grain_values(const std::vector<std::pair<std::string, ParameterValue>>& settings = {}) {
  ParameterValues values(find_model("grains").parameters);
  for (const auto& [key, value] : settings) values.set(key, value);
  return values;
}

Terrain bed(Extent extent, const Model& model, std::int32_t parcels, Boundary boundary = Boundary::torus) {
  Terrain terrain(extent, 0.01, model.quantum(), boundary);
  terrain.edit_mobile().fill(parcels);
  terrain.open_ledger();
  return terrain;
}

/// A model, its bed and an executor.
struct GrainRun {
  explicit GrainRun(const std::vector<std::pair<std::string, ParameterValue>>& settings, Extent extent = {64, 64},
                    std::int32_t parcels = 200, Boundary boundary = Boundary::torus)
      : model(grain_values(settings)),
        terrain(bed(extent, model, parcels, boundary)),
        executor(make_executor({.name = "cpu", .threads = 2})) {
    model.begin(terrain);
  }

  StepReport steps(int count, WindNow wind) {
    StepReport total;
    for (int k = 0; k < count; ++k) {
      total += model.step(terrain, wind, {5, step++}, *executor);
      if (step % 5 == 0) migration.observe(static_cast<std::int64_t>(step), surface());
    }
    return total;
  }
  CoarseSurface surface() const { return coarse_surface(terrain, Layer::surface); }
  double reading(const std::string& key) const {
    for (const Reading& one : model.readings()) {
      if (one.key == key) return one.value;
    }
    ADD_FAILURE() << "no reading " << key;
    return 0;
  }

  GrainModel model;
  Terrain terrain;
  std::unique_ptr<Executor> executor;
  std::uint64_t step = 0;
  MigrationTracker migration;
};

GrainLaw calm_law() {
  GrainLaw law = grain_law(grain_values(), {270, 0.1}, wind_frame({8, 8}, 270), 0.01);
  for (float& speed : law.wind_speed) speed = 0;
  return law;
}

TEST(Grains, EnergyNeverRisesInABounce) {
  const GrainLaw law = calm_law();
  GrainDice dice{17};
  for (int k = 0; k < 20000; ++k) {
    const auto signed_unit = [&] { return 2 * dice.unit() - 1; };
    Grain grain;
    grain.speed_u = 8 * signed_unit();
    grain.speed_v = 8 * signed_unit();
    grain.speed_z = 4 * signed_unit();
    const GroundSpot spot{0, 0, 1, 3 * signed_unit(), 3 * signed_unit()};
    const auto energy = [&] {
      return grain.speed_u * grain.speed_u + grain.speed_v * grain.speed_v + grain.speed_z * grain.speed_z;
    };
    const float before = energy();
    bounce(law, spot, grain);
    EXPECT_LE(energy(), before * 1.00001f);
    EXPECT_GE(grain.speed_z - grain.speed_u * spot.slope_u - grain.speed_v * spot.slope_v, -1e-4f) << "into the ground";
  }
}

TEST(Grains, ABounceOnLevelGroundDampsBothParts) {
  const GrainLaw law = calm_law();
  Grain grain;
  grain.speed_v = 3;
  grain.speed_z = -1;
  bounce(law, {0, 0, 1, 0, 0}, grain);
  EXPECT_FLOAT_EQ(grain.speed_v, 1.8f);
  EXPECT_FLOAT_EQ(grain.speed_z, 0.4f);
}

/// Notes the first touch of the ground.
struct FirstImpact {
  float speed = 0;
  int count = 0;
  void at(const Grain&) {}
  void impact(int, int, int, float impact_speed) {
    if (count++ == 0) speed = impact_speed;
  }
};

TEST(Grains, WithoutAirAGrainFliesAParabola) {
  GrainLaw law = calm_law();
  law.time_step = 1e-4f;
  law.longest_steps = 100000;
  law.bounce_limit = 1;
  const std::vector<GroundPoint> level((64 + 2) * (64 + 2));
  const FrozenGround ground{level.data(), 64, 64, true};
  Grain grain;
  grain.u = grain.v = 20;
  grain.speed_v = 1.5f;
  grain.speed_z = 1;
  GrainDice dice{1};
  FlightSums sums;
  FirstImpact watch;
  EXPECT_EQ(fly(law, ground, grain, dice, sums, watch), FlightEnd::rested);
  // Way 2 v w / g, speed of impact as at the start; the first-order time step errs by g dt / w.
  EXPECT_NEAR(grain.along, 2 * 1.5 * 1 / 9.81, 0.001);
  EXPECT_NEAR(watch.speed, std::hypot(1.5, 1.0), 0.003);
  EXPECT_NEAR(grain.v, 20 + 30.58, 0.1);
}

TEST(Grains, TheProfileIsLogarithmicAndItsTableExact) {
  const ParameterValues values = grain_values();
  const double threshold = lifting_threshold(values, 0.25e-3);
  EXPECT_NEAR(threshold, 0.7 * std::sqrt(0.0123 * (2655 / 1.1644 * 9.81 * 0.25e-3 + 3e-4 / (1.1644 * 0.25e-3))), 1e-12);
  EXPECT_NEAR(profile_speed(values, 0.15, 1.0), 0.15 / 0.4 * std::log(1 / (0.25e-3 / 30)), 1e-9);
  // All winds over the threshold meet at the focus.
  EXPECT_DOUBLE_EQ(profile_speed(values, 0.3, 0.02), profile_speed(values, 0.6, 0.02));
  EXPECT_GT(profile_speed(values, 0.6, 0.1), profile_speed(values, 0.3, 0.1));
  for (const double speed : {6.0, 10.0, 15.0}) {
    EXPECT_NEAR(profile_speed(values, friction_velocity(values, speed), 10), speed, 1e-9);
  }
  const GrainLaw law = grain_law(values, {270, 12}, wind_frame({8, 8}, 270), 0.01);
  for (const double height : {1e-4, 0.003, 0.0199, 0.05, 0.7, 11.0}) {
    const double exact = profile_speed(values, friction_velocity(values, 12), height);
    EXPECT_NEAR(wind_at(law, static_cast<float>(height)), exact, 0.01 * exact) << height;
  }
}

TEST(Grains, RipplesLieAcrossTheWindAndMoveDownwind) {
  for (const double bearing : {270.0, 235.0, 180.0}) {
    GrainRun run({{"strength_is", std::string("friction_velocity")}});
    run.steps(45, {bearing, 0.4});
    const SpectrumNumbers numbers = measure_spectrum(run.surface());
    EXPECT_LE(std::abs(std::remainder(numbers.crest_bearing - bearing - 90, 180.0)), 10) << bearing;
    EXPECT_GT(numbers.alignment, 0.25) << bearing;
    EXPECT_GT(measure(run.terrain).sd_surface, 0.002) << bearing;
    const Shift velocity = run.migration.velocity().value();
    const Direction toward = downwind(bearing);
    EXPECT_GT(velocity.x * toward.x + velocity.y * toward.y, 0.05) << bearing;
    EXPECT_EQ(run.reading("cut_off"), 0);
  }
}

TEST(Grains, WithoutSplashNothingMigrates) {
  GrainRun run({{"splash", 0.0}});
  run.steps(45, {270, 12});
  EXPECT_LT(measure(run.terrain).sd_surface, 0.0015);  // ripples would have four times that by now
  EXPECT_LT(run.migration.velocity().value_or(Shift{}).x, 0.05);
}

TEST(Grains, LeapAndImpactAngleGrowAndStayInTheirRanges) {
  double last = 0;
  for (const double friction : {0.2, 0.4, 0.6}) {
    GrainRun run({{"strength_is", std::string("friction_velocity")}});
    run.steps(3, {270, friction});
    EXPECT_GT(run.reading("flight"), 1.5 * last) << friction;
    EXPECT_GT(run.reading("impact_angle"), 8) << friction;
    EXPECT_LT(run.reading("impact_angle"), 17) << friction;
    EXPECT_EQ(run.reading("cut_off"), 0);
    last = run.reading("flight");
  }
  EXPECT_GT(last, 0.4);
  EXPECT_LT(last, 1.5);
}

TEST(Grains, RestBelowTheThreshold) {
  GrainRun run({{"strength_is", std::string("friction_velocity")}});
  const std::uint64_t before = state_hash(run.terrain);
  EXPECT_EQ(run.steps(2, {270, 0.19}).lifts, 0);
  EXPECT_EQ(state_hash(run.terrain), before);
}

TEST(Grains, FlightsThatAreCutOffAreCountedAndKeepTheirGrain) {
  GrainRun run({{"longest_flight", 0.1}}, {32, 32});
  const std::int64_t start = run.terrain.total_mobile();
  run.steps(2, {270, 20});
  EXPECT_GT(run.reading("cut_off"), 0);
  EXPECT_EQ(run.terrain.total_mobile(), start);
}

TEST(Grains, ASteepHumpSlidesToRepose) {
  GrainRun run({}, {60, 60}, 0);
  Grid<std::int32_t>& mobile = run.terrain.edit_mobile();
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 60; ++x) {
      mobile(x, y) = std::max(0, static_cast<int>(700 - 70 * std::hypot(x - 30, y - 30)));
    }
  }
  run.terrain.open_ledger();
  run.steps(40, {270, 1});  // calm: only slides
  const StandingSteps standing = StandingSteps::of_angle(33, 0.01, run.model.quantum());
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 60; ++x) {
      EXPECT_LE(std::abs(mobile(x, y) - mobile.wrapped(x + 1, y)), standing.straight);
      EXPECT_LE(std::abs(mobile(x, y) - mobile.wrapped(x, y + 1)), standing.straight);
      EXPECT_LE(std::abs(mobile(x, y) - mobile.wrapped(x + 1, y + 1)), standing.diagonal);
      EXPECT_LE(std::abs(mobile(x, y) - mobile.wrapped(x + 1, y - 1)), standing.diagonal);
    }
  }
  EXPECT_EQ(run.terrain.total_mobile(), run.terrain.ledger().expected());
  EXPECT_GT(measure(run.terrain).max_slabs, 200);
}

TEST(Grains, PlantsGatherSandInTheirWake) {
  GrainRun run({{"plants", std::int64_t{1}}, {"plant_diameter", 0.06}, {"plant_height", 0.03}});
  run.steps(40, {270, 9});
  // The plant stands in the middle, at cell (32, 32).
  std::int64_t wake = 0;
  for (int x = 32; x < 48; ++x) {
    for (int y = 24; y < 40; ++y) wake += run.terrain.mobile()(x, y) - 200;
  }
  EXPECT_GT(wake, 16 * 16 * 8) << "at least eight parcels a cell more than at first";
}

TEST(Grains, PlantsShelterWhereTheyStandNowFromTheWindThatBlowsNow) {
  const std::vector<std::pair<std::string, ParameterValue>> settings = {{"plants", std::int64_t{1}}};
  GrainRun run(settings, {48, 40});
  GrainRun anew(settings, {48, 40});
  for (const double bearing : {270.0, 270.0, 200.0, 235.0}) {
    run.steps(1, {bearing, 9});
    GrainModel other(grain_values(settings));  // which knows nothing of the steps before
    other.begin(anew.terrain);
    other.step(anew.terrain, {bearing, 9}, {5, anew.step++}, *anew.executor);
    EXPECT_EQ(state_hash(run.terrain), state_hash(anew.terrain)) << "step " << run.step;
    for (GrainRun* one : {&run, &anew}) {
      const int x = static_cast<int>(7 * one->step);
      find_field(one->terrain.edit_fields(), plants_field)->values(x, 20) = 1;
    }
  }
}

TEST(Grains, SnowThatRestsFlattensAndHardens) {
  GrainRun run({{"grain_density", 917.0}, {"bonding_time", 20.0}, {"settling", 0.02}}, {48, 48});
  const std::int64_t fresh = run.steps(30, {270, 9}).lifts / 30;
  const double rough = measure(run.terrain).sd_surface;
  run.steps(120, {270, 1});  // calm
  EXPECT_LT(measure(run.terrain).sd_surface, 0.9 * rough);
  EXPECT_LT(run.steps(1, {270, 9}).lifts, fresh / 4);
  EXPECT_EQ(run.terrain.total_mobile(), run.terrain.ledger().expected());
}

TEST(Grains, LogNormalDiametersSpreadTheLeaps) {
  GrainRun even({}, {32, 32});
  GrainRun spread({{"diameter_spread", 0.4}}, {32, 32});
  const StepReport all = even.steps(1, {270, 8});
  const StepReport some = spread.steps(1, {270, 8});
  EXPECT_GT(all.lifts, 0.99 * static_cast<double>(all.polls));
  EXPECT_LT(some.lifts, all.lifts) << "the coarsest grains stay";
  EXPECT_GT(some.lifts, all.lifts / 2);
}

TEST(Grains, PathsDoNotJumpOverTheTorus) {
  for (const double bearing : {270.0, 200.0}) {
    GrainRun run({}, {48, 40});
    run.model.keep_paths(30);
    run.steps(1, {bearing, 13});
    const std::vector<GrainPath> paths = run.model.paths();
    EXPECT_GE(paths.size(), 30u);
    for (const GrainPath& path : paths) {
      ASSERT_GE(path.size(), 2u);
      for (std::size_t k = 1; k < path.size(); ++k) {
        EXPECT_LT(std::hypot(path[k][0] - path[k - 1][0], path[k][1] - path[k - 1][1]), 0.1);
        EXPECT_GE(path[k][0], 0);
        EXPECT_LE(path[k][0], 0.48f);
        EXPECT_GE(path[k][1], 0);
        EXPECT_LE(path[k][1], 0.40f);
        EXPECT_GT(path[k][2], 0);
      }
    }
  }
}

TEST(Grains, KeepingPathsChangesNothing) {
  GrainRun plain({}, {40, 40});
  GrainRun watched({}, {40, 40});
  watched.model.keep_paths(10);
  plain.steps(3, {250, 12});
  watched.steps(3, {250, 12});
  EXPECT_EQ(state_hash(plain.terrain), state_hash(watched.terrain));
}

struct Case {
  std::string name;
  World world;
  bool rocks = false;
};

std::uint64_t hash_of(const Case& scene, const ExecutorOptions& options) {
  Terrain terrain = scene.world.strewn();
  if (scene.rocks) raise_rocks(terrain, 150);
  scene.world.run(terrain, options, 4);
  return state_hash(terrain);
}

TEST(Grains, SameBitsOnEveryExecutorAndAnyNumberOfThreads) {
  const std::vector<Case> cases = {
      {"straight", {.model = "grains", .extent = {70, 50}, .sand = 20}},
      {"oblique, odd, rocks", {.model = "grains", .extent = {51, 67}, .wind = {237, 6}, .sand = 20}, true},
      {"open", {.model = "grains", .extent = {60, 45}, .boundary = Boundary::open, .inflow = 3, .wind = {290, 5}}},
      {"snow among plants",
       {.model = "grains",
        .extent = {64, 64},
        .wind = {20, 5},
        .settings = {{"bonding_time", 5.0}, {"settling", 0.02}, {"plants", std::int64_t{3}}, {"diameter_spread", 0.3}},
        .sand = 10}}};
  for (const Case& scene : cases) {
    const std::uint64_t serial = hash_of(scene, {.name = "serial"});
    for (const int threads : {1, 2, 5}) {
      EXPECT_EQ(hash_of(scene, {.name = "cpu", .threads = threads}), serial) << scene.name << ", " << threads;
    }
    Terrain terrain = scene.world.strewn();
    if (scene.rocks) raise_rocks(terrain, 150);
    scene.world.run(terrain, {.name = "cpu"}, 2);
    scene.world.run(terrain, {.name = "cpu"}, 2, 2);
    EXPECT_EQ(state_hash(terrain), serial) << scene.name << ", cut in two";
  }
}

}  // namespace
}  // namespace erg::test
