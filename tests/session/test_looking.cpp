// Numbers over time, cells, sections, histograms, the log, exports.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <thread>

#include "../unit/temporary_folder.h"
#include "session/exporter.h"
#include "session/log.h"
#include "session/probe.h"
#include "session/runner.h"
#include "session/series.h"
#include "small_config.h"

namespace erg {

using io::run_numbers;
using session::clock_text;
using session::cut_section;
using session::Export;
using session::export_run;
using session::height_histogram;
using session::Histogram;
using session::Log;
using session::LogLevel;
using session::read_cell;
using session::Runner;
using session::Section;
using session::Series;
using session::slope_histogram;
using session::thickness_histogram;
using sim::Config;
using sim::Simulation;

namespace {

namespace fs = std::filesystem;
using test::small_config;

std::vector<double> row_at(double step) {
  std::vector<double> row(run_numbers().size(), 2 * step);
  row[0] = step;
  return row;
}

TEST(Series, SpansAnyRunEvenlyInBoundedSpace) {
  Series series;
  for (std::int64_t step = 0; step <= 10000; ++step) {
    if (series.due(step)) series.add(row_at(static_cast<double>(step)));
  }
  EXPECT_EQ(series.stride(), 16);  // 10001 rows halved until they fit into 1024
  EXPECT_LE(series.rows(), Series::most_rows);
  EXPECT_GE(series.rows(), Series::most_rows / 2);
  EXPECT_EQ(series.value(0, 0), 0);
  EXPECT_EQ(series.last_step(), 10000);
  for (std::size_t row = 0; row < series.rows(); ++row) {
    ASSERT_EQ(series.value(row, 0), 16.0 * static_cast<double>(row));
    ASSERT_EQ(series.value(row, 3), 2 * series.value(row, 0));
  }
  series.cut(5000);
  EXPECT_LT(series.last_step(), 5000);
  EXPECT_EQ(series.column(0).size(), series.rows());
}

TEST(Series, OfARunIsWhatTheRunWas) {
  Log log;
  Runner runner(log);
  runner.create({small_config("serial")});
  runner.run(40);
  runner.wait_until_still();
  const auto now = runner.snapshot();
  const Series& series = *now->runs[0].series;
  ASSERT_GE(series.rows(), 2u);
  EXPECT_EQ(series.value(0, 0), 0);
  const std::size_t spread = 6;
  ASSERT_EQ(run_numbers()[spread].key, "sd_slabs");
  for (std::size_t row = 0; row < series.rows(); ++row) {
    Simulation simulation(small_config("serial"));
    io::RunMeter meter(simulation.totals(), 0);
    for (int step = 0; step < static_cast<int>(series.value(row, 0)); ++step) simulation.step();
    EXPECT_EQ(series.value(row, spread), meter.take(simulation)[spread]) << "spread of thickness, row " << row;
  }
}

/// A plane that rises one quantum a cell eastward and two northward, with quanta of half a metre on cells of 2 m.
Terrain plane() {
  Terrain terrain({20, 10}, 2.0, 0.5, Boundary::open);
  Grid<std::int32_t>& bedrock = terrain.edit_bedrock();
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 20; ++x) bedrock(x, y) = x + 2 * y;
  }
  terrain.edit_mobile()(4, 5) = 0;
  return terrain;
}

TEST(Clock, TellsWhatTimeItIsInTheModelsWorld) {
  EXPECT_EQ(clock_text(Config("werner"), 10), "step 10, 202.9 days");
  EXPECT_EQ(clock_text(Config("grains"), 10), "step 10") << "its time step is that of a flight";
  Config plants("nield_baas");
  plants.parameters.set("steps_per_year", std::int64_t{80});
  EXPECT_EQ(clock_text(plants, 40), "step 40, 182.6 days");
  Config snow("snow_sintering");
  snow.parameters.set("time_step", 60.0);
  EXPECT_EQ(clock_text(snow, 90), "step 90, 1.5 h");
}

TEST(Probe, ReadsACellOfAPlane) {
  const session::CellReading reading = read_cell(plane(), {4, 5});
  EXPECT_EQ(reading.bedrock, 14);
  EXPECT_DOUBLE_EQ(reading.height, 7);
  EXPECT_NEAR(reading.slope, std::atan(std::sqrt(5.0) * 0.25) * 180 / M_PI, 1e-9);
  EXPECT_NEAR(reading.uphill, std::atan2(1, 2) * 180 / M_PI, 1e-9);
  EXPECT_NEAR(read_cell(plane(), {0, 0}).slope, reading.slope, 1e-9) << "at the open edge too";
  EXPECT_EQ(reading.text(), "cell 4, 5   height 7.00 m   0 slabs, 0.00 m thick   slope 29°");
}

TEST(Probe, CutsASectionThroughAPlane) {
  const Section section = cut_section(plane(), {1, 2}, {13, 8});
  ASSERT_EQ(section.distance.size(), 13u);
  EXPECT_DOUBLE_EQ(section.distance.back(), std::sqrt(12.0 * 12 + 6 * 6) * 2);
  EXPECT_DOUBLE_EQ(section.surface.front(), 2.5);
  EXPECT_DOUBLE_EQ(section.surface.back(), 14.5);
  const Section point = cut_section(plane(), {3, 3}, {3, 3});
  EXPECT_EQ(point.distance, std::vector<double>{0});
}

TEST(Probe, HistogramsCountEveryCellOnce) {
  Simulation simulation(small_config());
  for (int step = 0; step < 30; ++step) simulation.step();
  const Terrain& terrain = simulation.terrain();
  const auto all = [](const Histogram& histogram) {
    return std::accumulate(histogram.counts.begin(), histogram.counts.end(), 0.0);
  };
  EXPECT_EQ(all(thickness_histogram(terrain)), 48 * 40);
  EXPECT_EQ(all(height_histogram(terrain)), 48 * 40);
  EXPECT_EQ(all(slope_histogram(terrain)), 48 * 40);
  const Histogram thickness = thickness_histogram(terrain);
  double slabs = 0;
  for (std::size_t i = 0; i < thickness.counts.size(); ++i) slabs += static_cast<double>(i) * thickness.counts[i];
  EXPECT_EQ(thickness.width, 1);
  EXPECT_EQ(slabs, static_cast<double>(terrain.total_mobile()));
  EXPECT_LE(thickness_histogram(terrain, 4).counts.size(), 4u);
  EXPECT_LE(height_histogram(plane(), 7).counts.size(), 7u);
  // A plane has one slope only.
  const Histogram slopes = slope_histogram(plane());
  EXPECT_EQ(slopes.counts[14], 200) << "29.2 degrees";
}

TEST(Probe, WritesWhatItShowsAsCsv) {
  const TemporaryFolder folder;
  session::write_section(folder / "section.csv", cut_section(plane(), {0, 0}, {1, 0}), {});
  const std::string section = read_bytes(folder / "section.csv");
  EXPECT_NE(section.find("distance_m,bedrock_m,surface_m\n0,0,0\n2,0.5,0.5\n"), std::string::npos) << section;
  session::write_histogram(folder / "slopes.csv", {10, 2, {3, 4}}, "slope_deg", {});
  const std::string slopes = read_bytes(folder / "slopes.csv");
  EXPECT_NE(slopes.find("slope_deg_from,slope_deg_to,cells\n10,12,3\n12,14,4\n"), std::string::npos) << slopes;
}

TEST(Log, KeepsLinesByLevelAndForgetsTheOldest) {
  Log log;
  log.information("one\ntwo");
  log.warning("three");
  log.mistakes(InputError({{"a.json:3", "unknown key", "did you mean x?"}, {"a.json:9", "too large", ""}}));
  const std::vector<session::LogLine> lines = log.lines();
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[1].text, "two");
  EXPECT_EQ(lines[3].text, "a.json:3: unknown key; did you mean x?");
  EXPECT_EQ(log.lines(LogLevel::warning).size(), 3u);
  EXPECT_EQ(log.count(LogLevel::error), 2u);
  EXPECT_NE(log.text(LogLevel::error).find("error: a.json:9: too large\n"), std::string::npos);
  const std::uint64_t version = log.version();
  for (std::size_t i = 0; i < 2 * Log::kept_lines; ++i) log.information("more");
  EXPECT_EQ(log.lines().size(), Log::kept_lines);
  EXPECT_NE(log.version(), version);
  log.clear();
  EXPECT_TRUE(log.lines().empty());
}

struct ExportTest : testing::Test {
  TemporaryFolder folder;
  Log log;
  Runner runner{log};
  std::shared_ptr<const session::Snapshot> snapshot;

  ExportTest() {
    runner.create({small_config()});
    runner.run(5);
    runner.wait_until_still();
    snapshot = runner.snapshot();
  }
};

TEST_F(ExportTest, EveryFormatIsWritten) {
  for (const session::ExportFormat& format : session::export_formats()) {
    const fs::path path = folder / ("dunes-" + format.key + format.ending);
    Export work(path, format.key, snapshot, 0);
    while (work.state() == Export::State::writing) std::this_thread::yield();
    EXPECT_EQ(work.state(), Export::State::done) << format.key << ": " << work.problem();
    EXPECT_EQ(work.progress(), 1) << format.key;
    EXPECT_GT(fs::file_size(path), 100u) << format.key;
  }
  const io::Saved saved = io::read_checkpoint(folder / "dunes-checkpoint.checkpoint");
  EXPECT_EQ(state_hash(saved.state.terrain), state_hash(*snapshot->runs[0].terrain));
  EXPECT_EQ(saved.state.step, 5);
}

TEST_F(ExportTest, AStoppedOneLeavesTheOldFile) {
  const fs::path path = folder / "dunes.obj";
  write_bytes(path, "old");
  double last = 0;
  EXPECT_THROW(export_run(path, "obj", snapshot->runs[0],
                          [&](double part) {
                            EXPECT_GT(part, last);
                            last = part;
                            return part < 0.5;
                          }),
               io::StoppedWriting);
  EXPECT_EQ(read_bytes(path), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1)
      << "nothing half written";
}

TEST_F(ExportTest, AFailureIsSaid) {
  Export work(folder / "nowhere" / "dunes.ply", "ply", snapshot, 0);
  while (work.state() == Export::State::writing) std::this_thread::yield();
  EXPECT_EQ(work.state(), Export::State::failed);
  EXPECT_NE(work.problem(), "");
  EXPECT_THROW(export_run(folder / "x", "no such", snapshot->runs[0], {}), InputError);
}

}  // namespace
}  // namespace erg
