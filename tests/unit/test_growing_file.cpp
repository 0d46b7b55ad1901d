#include "io/files/growing_file.h"

#include <gtest/gtest.h>

#include "io/files/atomic_file.h"
#include "io/formats/table.h"
#include "message.h"
#include "temporary_folder.h"

namespace erg {

using io::GrowingFile;
using io::TableFile;
using sim::Config;

namespace {

namespace fs = std::filesystem;

TEST(GrowingFile, IsHeldByOneAtATime) {
  const TemporaryFolder folder;
  {
    GrowingFile first(folder / "a.csv");
    first.replace("one\n");
    first.append("two\n");
    EXPECT_EQ(message([&] { GrowingFile(folder / "a.csv"); }),
              (folder / "a.csv").string() +
                  ": another run is writing this file; give another folder with --out, or wait until it has ended");
    first.append("three\n");
    GrowingFile other(folder / "b.csv");
    other.append("x");
  }
  EXPECT_EQ(read_bytes(folder / "a.csv"), "one\ntwo\nthree\n");
  GrowingFile second(folder / "a.csv");  // it was let go
  second.append("four\n");
  EXPECT_EQ(read_bytes(folder / "a.csv"), "one\ntwo\nthree\nfour\n");
}

TEST(GrowingFile, IsTheSameFileThroughALink) {
  const TemporaryFolder folder;
  write_bytes(folder / "a.csv", "old");
  fs::create_symlink(folder / "a.csv", folder / "link.csv");
  GrowingFile file(folder / "link.csv");
  EXPECT_THROW(GrowingFile(folder / "a.csv"), InputError);
  file.replace("new");
  EXPECT_TRUE(fs::is_symlink(folder / "link.csv"));
  EXPECT_EQ(read_bytes(folder / "a.csv"), "new");
}

TEST(GrowingFile, DoesNotGrowWhatHasTakenItsName) {
  const TemporaryFolder folder;
  GrowingFile file(folder / "a.csv");
  file.replace("one\n");
  fs::remove(folder / "a.csv");
  write_bytes(folder / "a.csv", "another\n");
  EXPECT_THROW(file.append("two\n"), io::WriteError);
  EXPECT_EQ(read_bytes(folder / "a.csv"), "another\n");
}

/// Where a table of this config's run begins.
io::Provenance run_of(const Config& config) { return io::provenance_of(config, 0, "cpu", 2); }

std::string resumed(const fs::path& path, const Config& config) {
  return message([&] { TableFile::resume(path, {"step"}, run_of(config), 5); });
}

TEST(TableOfAnotherRun, IsNotGoneOnWith) {
  const TemporaryFolder folder;
  Config config;
  config.run.set("seed", std::int64_t{1});
  { TableFile(folder / "t.csv", {"step"}, run_of(config)).add(std::vector<double>{0.0}); }
  const std::string before = read_bytes(folder / "t.csv");

  Config other = config;
  other.run.set("seed", std::int64_t{2});
  EXPECT_EQ(resumed(folder / "t.csv", other),
            (folder / "t.csv").string() +
                ": holds the rows of another run: seed is 1 there and 2 here; name another folder with --out");
  other = config;
  sim::change_model(other, "werner");
  EXPECT_NE(resumed(folder / "t.csv", other).find("model is momiji there and werner here"), std::string::npos);
  other = config;
  other.grid.set("nx", std::int64_t{64});
  EXPECT_NE(resumed(folder / "t.csv", other).find("grid.nx is 256 there and 64 here"), std::string::npos);
  other = config;
  other.scene.set("sand", 7.0);
  EXPECT_NE(resumed(folder / "t.csv", other).find("scene.sand is 3 there and 7 here"), std::string::npos);
  EXPECT_EQ(read_bytes(folder / "t.csv"), before);

  // What may change on the way does not make it another run.
  other = config;
  other.run.set("steps", std::int64_t{5000});
  other.run.set("executor", std::string("serial"));
  other.wind = forcing::WindSchedule::constant(90, 7);
  EXPECT_EQ(resumed(folder / "t.csv", other), "no error");
  // A table without a head tells nothing.
  write_bytes(folder / "bare.csv", "step\n0\n");
  EXPECT_EQ(resumed(folder / "bare.csv", other), "no error");
}

TEST(TableOfAnotherRun, IsKnownByAConfigThatLiesBesideIt) {
  const TemporaryFolder folder;
  Config config;
  for (int k = 0; k < 500; ++k) {
    forcing::WindInterval season;
    season.bearing = k % 360;
    season.first = season.last = 4;
    config.wind.intervals.push_back(season);
  }
  { TableFile(folder / "t.csv", {"step"}, run_of(config)).add(std::vector<double>{0.0}); }
  EXPECT_EQ(resumed(folder / "t.csv", config), "no error");
  Config other = config;
  other.scene.set("sand", 7.0);
  EXPECT_NE(resumed(folder / "t.csv", other).find("scene.sand"), std::string::npos);
}

}  // namespace
}  // namespace erg
