#include "analysis/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis/crests.h"
#include "core/random.h"

namespace erg {

using analysis::CoarseSurface;
using analysis::crest_spacing;
using analysis::measure_spectrum;
using analysis::SpectrumNumbers;

namespace {

CoarseSurface waves(Extent extent, double waves_x, double waves_y, bool periodic = true) {
  CoarseSurface surface{Grid<double>(extent), 1, 1, periodic};
  for (int y = 0; y < extent.ny; ++y) {
    for (int x = 0; x < extent.nx; ++x) {
      surface.heights(x, y) =
          20 + 5 * std::sin(2 * std::numbers::pi * (waves_x * x / extent.nx + waves_y * y / extent.ny));
    }
  }
  return surface;
}

double axis_difference(double first, double second) {
  const double difference = std::fmod(std::abs(first - second), 180);
  return std::min(difference, 180 - difference);
}

TEST(Spectrum, TransformAndBack) {
  for (const Extent extent : {Extent{1, 1}, Extent{7, 1}, Extent{1, 6}, Extent{13, 10}, Extent{16, 8}}) {
    CoarseSurface surface{Grid<double>(extent), 1, 1, true};
    double sum = 0;
    for (std::size_t cell = 0; cell < surface.heights.size(); ++cell) {
      sum += surface.heights[cell] = random_unit({1, 0}, 0, cell, 0);
    }
    const Grid<double> back = analysis::transform_back(analysis::transform(surface));
    for (std::size_t cell = 0; cell < back.size(); ++cell) {
      EXPECT_NEAR(back[cell], surface.heights[cell] - sum / static_cast<double>(back.size()), 1e-12);
    }
  }
}

TEST(Spectrum, FindsWavelengthAndCrestsOfASine) {
  struct Case {
    Extent extent;
    double waves_x, waves_y;
  };
  for (const Case& one :
       {Case{{128, 128}, 4, 0}, {{128, 128}, 0, 5}, {{128, 128}, 3, 3}, {{200, 90}, 7, -2}, {{101, 67}, -3, 4}}) {
    const SpectrumNumbers found = measure_spectrum(waves(one.extent, one.waves_x, one.waves_y));
    const double kx = one.waves_x / one.extent.nx;
    const double ky = one.waves_y / one.extent.ny;
    EXPECT_NEAR(found.wavelength, 1 / std::hypot(kx, ky), 1e-6);
    // Crests are where kx x + ky y is constant: along (-ky, kx), as a bearing from north.
    const double crest = std::atan2(-ky, kx) * 180 / std::numbers::pi;
    ASSERT_TRUE(found.crest_bearing) << crest;
    EXPECT_LT(axis_difference(*found.crest_bearing, crest), 1e-6) << *found.crest_bearing << " for " << crest;
    EXPECT_GE(*found.crest_bearing, 0);
    EXPECT_LT(*found.crest_bearing, 180);
    EXPECT_NEAR(found.alignment, 1, 1e-9);
  }
}

TEST(Spectrum, CrestsAcrossAWestWindRunNorth) {
  EXPECT_NEAR(measure_spectrum(waves({64, 64}, 4, 0)).crest_bearing.value(), 0, 1e-9);
  EXPECT_NEAR(measure_spectrum(waves({64, 64}, 0, 4)).crest_bearing.value(), 90, 1e-9);
  // Height constant along x = y, which is north-east: 45 degrees.
  EXPECT_NEAR(measure_spectrum(waves({64, 64}, 4, -4)).crest_bearing.value(), 45, 1e-9);
}

TEST(Spectrum, WavesThatDoNotFitAnOpenGridAreFadedOut) {
  const SpectrumNumbers found = measure_spectrum(waves({200, 200}, 9.5, 0, false));
  EXPECT_NEAR(found.wavelength, 200 / 9.5, 0.05 * 200 / 9.5);
  EXPECT_LT(axis_difference(found.crest_bearing.value(), 0), 1);
}

TEST(Spectrum, AFlatSurfaceHasNone) {
  const SpectrumNumbers found = measure_spectrum({Grid<double>({31, 17}, 3.3), 1, 1, true});
  EXPECT_EQ(found.wavelength, 0);
  EXPECT_EQ(found.alignment, 0);
  EXPECT_FALSE(found.crest_bearing);
}

TEST(Spectrum, CrestsThatRunBothWaysHaveNoBearing) {
  // Two trains of waves across each other, the second with `share` of the first's power: (1 - share) / (1 + share).
  const auto crossed = [](double share) {
    CoarseSurface surface = waves({96, 96}, 6, 0);
    const CoarseSurface other = waves({96, 96}, 0, 6);
    for (std::size_t cell = 0; cell < surface.heights.size(); ++cell) {
      surface.heights[cell] += std::sqrt(share) * other.heights[cell];
    }
    return measure_spectrum(surface);
  };
  for (const double share : {0.0, 0.25, 0.4, 0.5, 1.0}) {
    const SpectrumNumbers found = crossed(share);
    EXPECT_NEAR(found.alignment, (1 - share) / (1 + share), 1e-9);
    EXPECT_EQ(found.crest_bearing.has_value(), found.alignment >= analysis::least_alignment) << share;
  }
  EXPECT_NEAR(crossed(0.4).crest_bearing.value(), 0, 1e-6);
}

TEST(Spectrum, LargeTerrainsAreAveragedInUnitsOfCells) {
  Terrain terrain({1500, 40}, 1.0, 0.001);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 1500; ++x) {
      terrain.edit_mobile()(x, y) = 1000 + static_cast<int>(std::lround(900 * std::sin(2 * std::numbers::pi * x / 50)));
    }
  }
  const CoarseSurface coarse = analysis::coarse_surface(terrain, analysis::Layer::mobile);
  EXPECT_EQ(coarse.heights.nx(), 1024);
  EXPECT_EQ(coarse.heights.ny(), 40);
  double sum = 0;
  for (const double height : coarse.heights.cells()) sum += height;
  EXPECT_NEAR(sum / static_cast<double>(coarse.heights.size()), static_cast<double>(terrain.total_mobile()) / 60000,
              1e-9);
  EXPECT_NEAR(measure_spectrum(coarse).wavelength, 50, 0.5);
}

TEST(Crests, StandAWavelengthApartAlongTheWind) {
  EXPECT_NEAR(crest_spacing(waves({128, 96}, 8, 0), 270), 16, 0.1);
  EXPECT_NEAR(crest_spacing(waves({128, 96}, 8, 0), 90), 16, 0.1);
  EXPECT_NEAR(crest_spacing(waves({128, 96}, 0, 6), 180), 16, 0.1);
  EXPECT_NEAR(crest_spacing(waves({90, 90}, 6, 6), 225), 15 / std::sqrt(2), 0.1);
  // Along an oblique wind the same crests are farther apart; along the crests there are none.
  EXPECT_NEAR(crest_spacing(waves({128, 96}, 8, 0), 210), 32, 0.2);
  EXPECT_EQ(crest_spacing(waves({128, 96}, 8, 0), 180), 0);
  EXPECT_EQ(crest_spacing({Grid<double>({31, 17}, 3.3), 1, 1, true}, 270), 0);
}

TEST(Crests, AreCountedAmongRubbleAndOnOpenOrAveragedGround) {
  CoarseSurface rubble = waves({256, 32}, 16, 0);
  for (std::size_t cell = 0; cell < rubble.heights.size(); ++cell) {
    rubble.heights[cell] += 4 * (random_unit({1, 0}, 0, cell, 0) - 0.5);
  }
  EXPECT_NEAR(crest_spacing(rubble, 270), 16, 0.4);
  EXPECT_LT(measure_spectrum(rubble).wavelength, 14);  // which the short waves pull down
  EXPECT_NEAR(crest_spacing(waves({200, 40}, 9.5, 0, false), 270), 200 / 9.5, 0.3);
  CoarseSurface blocks = waves({128, 64}, 8, 0);
  blocks.cells_x = 2.5;  // a block is as long as two and a half cells
  EXPECT_NEAR(crest_spacing(blocks, 270), 40, 0.5);
}

}  // namespace
}  // namespace erg
