#include "io/config/provenance.h"

#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "io/config/config_file.h"
#include "io/formats/heightmap.h"
#include "io/formats/mesh.h"
#include "io/formats/png.h"
#include "io/formats/table.h"
#include "io/formats/vti.h"
#include "temporary_folder.h"

namespace erg {

using io::Provenance;
using io::provenance_of;
using io::read_config;
using sim::Config;

namespace {

namespace fs = std::filesystem;

/// A config whose wind has so many seasons, as a record of years has.
Config of_seasons(int count) {
  Config config;
  config.wind.intervals.clear();
  for (int k = 0; k < count; ++k) {
    config.wind.intervals.push_back({k * 7 % 360 + 0.5, 3.0 + k % 5, 4, 3, {}});
  }
  return config;
}

std::map<std::string, std::string> entries_of(const Config& config, const fs::path& path) {
  const io::MetadataEntries entries = io::metadata_of_file(path, provenance_of(config, 0, "cpu", 2));
  return {entries.begin(), entries.end()};
}

TEST(Provenance, HoldsAShortConfigAndItsHash) {
  const TemporaryFolder folder;
  const Config config;
  const auto entries = entries_of(config, folder / "a.csv");
  EXPECT_EQ(entries.at("erg:config"), io::config_text(config));
  EXPECT_EQ(entries.at("erg:config-hash").size(), 16u);
  EXPECT_EQ(entries.count("erg:config-file"), 0u);
  Config other = config;
  other.scene.set("sand", 7.0);
  EXPECT_NE(entries_of(other, folder / "a.csv").at("erg:config-hash"), entries.at("erg:config-hash"));
}

TEST(Provenance, NamesTheFileOfALongOne) {
  const TemporaryFolder folder;
  const auto entries = entries_of(of_seasons(5000), folder / "a.csv");
  EXPECT_EQ(entries.count("erg:config"), 0u);
  EXPECT_EQ(entries.at("erg:config-file"), "config-" + entries.at("erg:config-hash") + ".json");
  EXPECT_EQ(read_config(folder / entries.at("erg:config-file")), of_seasons(5000));
}

TEST(Provenance, StandsWholeWhereNoFileCanLieBeside) {
  const Config config = of_seasons(5000);
  const auto piped = entries_of(config, "/dev/null");
  EXPECT_EQ(piped.at("erg:config"), io::config_text(config));
  EXPECT_EQ(piped.count("erg:config-file"), 0u);
  const std::string printed = io::table_text({"step"}, {{1}}, provenance_of(config, 0, "cpu", 2));
  EXPECT_EQ(printed.find("erg:config-file"), std::string::npos);
  std::istringstream lines(printed);
  std::string given;  // back out of its comment
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("# ") && !line.starts_with("# erg:")) given += line.substr(2) + "\n";
  }
  EXPECT_EQ(io::parse_config(given, ""), config) << "it can be run again";
}

TEST(Provenance, ThousandsOfSeasonsStandOnceBesideAllFiles) {
  const TemporaryFolder folder;
  const Config config = of_seasons(5000);
  const Provenance source = provenance_of(config, 3, "cpu", 2);
  const Terrain terrain({8, 8}, 1, 0.1);
  io::write_heightmap(folder / "h.png", terrain, source);
  io::write_vti(folder / "v.vti", terrain, nullptr, source);
  io::write_obj(folder / "o.obj", terrain, source);
  io::write_ply(folder / "p.ply", terrain, source);
  io::write_table(folder / "t.csv", {"step"}, {{1}}, source);
  io::write_run_png(folder / "r.png", picture::RgbImage(2, 2), source);
  int configs = 0;
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    if (entry.path().extension() != ".json") {
      EXPECT_LT(fs::file_size(entry.path()), 8000u) << entry.path();
      EXPECT_NE(read_bytes(entry.path()).find("config-"), std::string::npos) << entry.path();
      continue;
    }
    ++configs;
    EXPECT_EQ(read_config(entry.path()), config) << "it can be run again";
  }
  EXPECT_EQ(configs, 1);
}

TEST(Provenance, WindsOfManyThousandSeasonsAreRead) {
  const TemporaryFolder folder;
  const Config config = of_seasons(40000);
  io::write_config(folder / "long.json", config);
  EXPECT_GT(fs::file_size(folder / "long.json"), std::uintmax_t{1} << 20);
  EXPECT_EQ(read_config(folder / "long.json"), config);
}

}  // namespace
}  // namespace erg
