// Identities that follow from the rules by algebra.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/units.h"
#include "forcing/wind_frame.h"
#include "kernels/shadow.h"
#include "models/slab/slab_law.h"
#include "sim/make_executor.h"
#include "world.h"

namespace erg::test {

using models::Cover;
using models::CoverField;
using models::move_slabs;
using models::SlabLaw;
using models::StepReport;
using sim::make_executor;

namespace {

/// A law under which the bed stays flat: no shadow, slopes hardly slide, every cell polled once.
SlabLaw flat_bed_law() {
  SlabLaw law;
  law.shadow_fall = 1000;  // a shadow line that falls this fast never shelters
  law.bare = law.covered = {100, 100};
  law.repeated_polling = false;
  return law;
}

double mean_travel(const Machine& machine, SlabLaw law, std::int32_t sand) {
  // Thick sand never bares the ground; the thin layer's case sets both chances alike.
  Terrain terrain(Extent{200, 200}, 1, 1.0 / 3);
  terrain.edit_mobile().fill(sand);
  terrain.open_ledger();
  const auto executor = make_executor(machine.options);
  StepReport total;
  for (std::uint64_t step = 0; step < 5; ++step) total += move_slabs(*executor, terrain, law, {270, 5}, {11, step});
  EXPECT_EQ(total.polls, 5 * 200 * 200) << machine.name;
  EXPECT_EQ(total.lifts, total.polls) << machine.name;
  return total.travel / static_cast<double>(total.lifts);
}

TEST(Exact, MeanTravelOnAFlatBedIsHopLengthOverChanceToStay) {
  // 200 000 slabs, each a geometric number of hops: the standard error of the mean is below 0.02 cells.
  for (const Machine& machine : machines()) {
    SlabLaw law = flat_bed_law();
    EXPECT_NEAR(mean_travel(machine, law, 60), 5 / 0.6, 0.08) << machine.name;
    law.p_sand = law.p_bare;
    EXPECT_NEAR(mean_travel(machine, law, 60), 5 / 0.4, 0.12) << machine.name;
  }
}

TEST(Exact, MeanTravelHoldsForAnyHopLengthAtAnyBearing) {
  // Of hops that are no whole number of rows, and of those shorter than a row (or, at 45 degrees, than its diagonal).
  struct Wind {
    double strength, bearing, chance;
  };
  const std::vector<Wind> winds{{5, 250, 0.6},   {5, 250, 0.2}, {3, 250, 0.4},   {2.5, 270, 0.6},
                                {1.3, 240, 0.6}, {1, 225, 0.6}, {0.5, 270, 0.6}, {0.3, 285, 0.4}};
  struct Size {
    compute::ExecutorOptions options;
    int side, steps;
  };
  const std::vector<Size> sizes{{{.name = "cpu", .threads = 2, .sweeps = 16}, 512, 16}, {{.name = "serial"}, 256, 8}};
  for (const auto& [options, side, steps] : sizes) {
    for (const Wind& wind : winds) {
      SlabLaw law = flat_bed_law();
      law.p_sand = law.p_bare = wind.chance;
      Terrain terrain(Extent{side, side}, 1, 1.0 / 3);
      terrain.edit_mobile().fill(60);
      terrain.open_ledger();
      const auto executor = make_executor(options);
      StepReport total;
      for (std::uint64_t step = 0; step < static_cast<std::uint64_t>(steps); ++step) {
        total += move_slabs(*executor, terrain, law, {wind.bearing, wind.strength}, {11, step});
      }
      const double travel = total.travel / static_cast<double>(total.lifts);
      // A geometric number of hops scatters by sqrt(1 - p) of its mean; of hops shorter than a row only some are made.
      const double rows = std::min(1.0, wind.strength * forcing::wind_frame(terrain.extent(), wind.bearing).cosine);
      const double scatter = std::sqrt((2 - wind.chance) / rows - 1);
      const double error = 3 * scatter / std::sqrt(static_cast<double>(total.lifts));  // 0.1% on `cpu` but for hop 0.3
      EXPECT_NEAR(travel * wind.chance / wind.strength, 1, error)
          << options.name << ", hop " << wind.strength << " at " << wind.bearing << ", chance " << wind.chance;
    }
  }
}

TEST(Exact, ForcedErosionLiftsAsManySlabsAsThereAreCells) {
  for (const Machine& machine : machines()) {
    for (const bool repeated : {true, false}) {
      const World world{.extent = {128, 96}};
      Terrain terrain = world.strewn();
      SlabLaw law;
      law.forced_erosion = true;
      law.repeated_polling = repeated;
      const auto executor = make_executor(machine.options);
      constexpr int steps = 30;
      std::int64_t lifts = 0;
      for (std::uint64_t step = 0; step < steps; ++step)
        lifts += move_slabs(*executor, terrain, law, {280, 5}, {5, step}).lifts;
      EXPECT_NEAR(static_cast<double>(lifts) / (steps * 128 * 96), 1, 0.002) << machine.name << ", " << repeated;
    }
  }
}

TEST(Exact, CoverScalesLiftAndLanding) {
  // rho = 0.4: a slab lifts with 0.6 and stays with p + rho (1 - p) = 0.76.
  const Cover cover{CoverField(Extent{200, 200}, 102)};
  for (const Machine& machine : machines()) {
    SlabLaw law = flat_bed_law();
    law.cover = &cover;
    Terrain terrain(cover->extent(), 1, 1.0 / 3);
    terrain.edit_mobile().fill(60);
    terrain.open_ledger();
    const auto executor = make_executor(machine.options);
    const StepReport report = move_slabs(*executor, terrain, law, {270, 5}, {3, 0});
    EXPECT_NEAR(static_cast<double>(report.lifts) / 40000, 0.6, 0.012) << machine.name;
    EXPECT_NEAR(report.travel / static_cast<double>(report.lifts), 5 / 0.76, 0.12) << machine.name;
  }
}

TEST(Exact, FullCoverHoldsEverything) {
  const Cover cover{CoverField(Extent{40, 40}, 255)};
  for (const Machine& machine : machines()) {
    World world{.extent = cover->extent()};
    Terrain terrain = world.strewn();
    SlabLaw law = flat_bed_law();
    law.cover = &cover;
    const std::uint64_t before = state_hash(terrain);
    const auto executor = make_executor(machine.options);
    EXPECT_EQ(move_slabs(*executor, terrain, law, {270, 5}, {3, 0}).lifts, 0) << machine.name;
    executor->sync_to_host(terrain);
    EXPECT_EQ(state_hash(terrain), before) << machine.name;
  }
}

TEST(Exact, StandingStepsOfPrintedAngles) {
  EXPECT_EQ(critical_step(33.69, 1, 1.0 / 3), 2);  // tan = 2/3: exactly two slabs of a third
  EXPECT_EQ(critical_step(30, 1, 1.0 / 3), 2);
  EXPECT_EQ(critical_step(33.7, 1, 1.0 / 3), 3);
  EXPECT_EQ(critical_step(30, 1, 0.1), 6);
  EXPECT_EQ(critical_step(40, 1, 0.1), 9);
  EXPECT_NEAR(kernels::shadow_fall(15, 1, 1.0 / 3), 0.804, 0.0005);
}

TEST(Exact, HopGrowsWithHeightAsPrinted) {
  const models::HopLaw momiji{0.4, 0.002, 0};
  EXPECT_DOUBLE_EQ(momiji.cells(5, 10), 5 + 4 + 0.2);
  EXPECT_DOUBLE_EQ(momiji.cells(5, -5), 3);   // no square below the reference
  EXPECT_DOUBLE_EQ(momiji.cells(5, -20), 1);  // never below one cell
}

TEST(Exact, NothingStandsSteeperThanRepose) {
  for (const Machine& machine : machines()) {
    World world{.extent = {64, 64}};
    Terrain terrain = world.strewn();
    // Full cover: no wind at work, only slides.
    const Cover cover{CoverField(world.extent, 255)};
    SlabLaw law;
    law.cover = &cover;
    terrain.edit_mobile()(20, 20) = 60;
    terrain.open_ledger();
    const auto executor = make_executor(machine.options);
    if (executor->name() == "serial") continue;  // slides only where a slab moves
    for (std::uint64_t step = 0; step < 30; ++step) move_slabs(*executor, terrain, law, {270, 5}, {3, step});
    executor->sync_to_host(terrain);
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        EXPECT_LE(std::abs(terrain.mobile()(x, y) - terrain.mobile().wrapped(x + 1, y)), law.bare.straight);
        EXPECT_LE(std::abs(terrain.mobile()(x, y) - terrain.mobile().wrapped(x, y + 1)), law.bare.straight);
      }
    }
    EXPECT_EQ(terrain.total_mobile(), terrain.ledger().expected());
  }
}

TEST(Exact, StepsTooLongForSixteenBitsStand) {
  const Cover cover{CoverField(Extent{40, 40}, 255)};
  for (const Machine& machine : machines()) {
    World world{.extent = cover->extent(), .sand = 30};
    Terrain terrain = world.strewn();
    SlabLaw law = flat_bed_law();
    law.bare = {3, 4};
    law.covered = {0x10000 - 20, 0x20000 - 20};
    law.neighbours = 8;
    law.cover = &cover;
    const std::uint64_t before = state_hash(terrain);
    const auto executor = make_executor(machine.options);
    move_slabs(*executor, terrain, law, {270, 5}, {3, 0});
    executor->sync_to_host(terrain);
    EXPECT_EQ(state_hash(terrain), before) << machine.name;
  }
}

TEST(Exact, NothingStandsSteeperThanReposeOnSkewedPlanes) {
  // Two blocks of columns whose rows are shifted against each other: every edge of the torus must still be looked at.
  for (const double bearing : {270.0, 248.0, 225.0}) {
    Terrain terrain(Extent{270, 290}, 1, 1.0 / 3);
    for (std::size_t cell = 0; cell < terrain.mobile().size(); ++cell) {
      terrain.edit_mobile()[cell] = static_cast<std::int32_t>(random_below({5, 0}, 0, cell, 0, 12));
    }
    terrain.open_ledger();
    const Cover cover{CoverField(terrain.extent(), 255)};
    SlabLaw law;
    law.cover = &cover;
    law.neighbours = 8;
    const auto executor = make_executor({.name = "cpu", .threads = 2, .lines_a_thread = 1});
    for (std::uint64_t step = 0; step < 12; ++step) move_slabs(*executor, terrain, law, {bearing, 5}, {3, step});
    executor->sync_to_host(terrain);
    const Grid<std::int32_t>& mobile = terrain.mobile();
    for (int y = 0; y < terrain.ny(); ++y) {
      for (int x = 0; x < terrain.nx(); ++x) {
        const std::int32_t here = mobile(x, y);
        ASSERT_LE(std::abs(here - mobile.wrapped(x + 1, y)), law.bare.straight) << x << ", " << y << ", " << bearing;
        ASSERT_LE(std::abs(here - mobile.wrapped(x, y + 1)), law.bare.straight) << x << ", " << y << ", " << bearing;
        ASSERT_LE(std::abs(here - mobile.wrapped(x + 1, y + 1)), law.bare.diagonal) << x << ", " << y;
        ASSERT_LE(std::abs(here - mobile.wrapped(x - 1, y + 1)), law.bare.diagonal) << x << ", " << y;
      }
    }
    EXPECT_EQ(terrain.total_mobile(), terrain.ledger().expected());
  }
}

TEST(Exact, ATallConeSlidesToTheSameSlopeInEveryAzimuthWithEightNeighbours) {
  Terrain terrain(Extent{161, 161}, 1, 0.1);
  for (int y = 0; y < 161; ++y) {
    for (int x = 0; x < 161; ++x) {
      const double radius = std::hypot(x - 80, y - 80);
      terrain.edit_mobile()(x, y) = static_cast<std::int32_t>(std::max(0.0, 400 - 14 * radius));
    }
  }
  terrain.open_ledger();
  const Cover cover{CoverField(terrain.extent(), 255)};
  SlabLaw law;
  law.cover = &cover;
  law.neighbours = 8;
  law.bare = law.covered = models::ReposeSteps::of_angle(33, 1, 0.1);
  const auto executor = make_executor({.name = "cpu", .threads = 2, .lines_a_thread = 1});
  for (std::uint64_t step = 0; step < 400; ++step) move_slabs(*executor, terrain, law, {270, 5}, {3, step});
  executor->sync_to_host(terrain);
  // The foot of the cone, where it falls under 20 slabs, in 16 azimuths.
  double nearest = 1e9;
  double farthest = 0;
  for (int k = 0; k < 16; ++k) {
    const double azimuth = k * std::acos(-1.0) / 8;
    double radius = 0;
    while (radius < 79 && terrain.height(80 + static_cast<int>(std::lround(radius * std::cos(azimuth))),
                                         80 + static_cast<int>(std::lround(radius * std::sin(azimuth)))) > 20) {
      radius += 0.25;
    }
    nearest = std::min(nearest, radius);
    farthest = std::max(farthest, radius);
  }
  EXPECT_LT(farthest / nearest, 1.10);
  EXPECT_GT(nearest, 25);
}

}  // namespace
}  // namespace erg::test
