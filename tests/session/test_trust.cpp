// The window's files and runs when things go wrong outside: killed while saving, a full disk, no permission, too little
// memory.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <map>
#include <new>
#include <thread>

#include "../unit/limits.h"
#include "../unit/temporary_folder.h"
#include "io/checkpoint/start_simulation.h"
#include "io/config/config_file.h"
#include "io/files/atomic_file.h"
#include "io/formats/camera_file.h"
#include "session/app_model.h"
#include "sim/memory.h"
#include "small_config.h"
#include "snapshot_of.h"

namespace erg::test::trust {

using io::Saved;
using io::write_config;
using io::WriteError;
using session::Activity;
using session::LogLevel;
using session::Runner;
using session::Session;
using session::Settings;
using session::Snapshot;
using sim::check_memory;
using sim::Config;

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

/// A file that the window writes, twice with another content, and what makes sure that it is whole.
struct Writer {
  std::string name;
  std::function<void(const fs::path& file, int version)> write;
  std::function<void(const fs::path& file)> check;
};

Snapshot snapshot_of(int version) {
  sim::Simulation simulation(small_config("serial", version));
  simulation.step();
  return test::snapshot_of(simulation, static_cast<std::uint64_t>(version));
}

Settings settings_of(int version) {
  Settings settings;
  settings.window_width = 1000 + version;
  for (int i = 0; i < 10; ++i) settings.recent.push_back("/a/folder/file" + std::to_string(version));
  return settings;
}

std::vector<Writer> writers() {
  static const std::array snapshots{snapshot_of(0), snapshot_of(1)};
  std::vector<Writer> all{
      {"setup.json", [](const fs::path& file, int version) { write_config(file, small_config("serial", version)); },
       [](const fs::path& file) { io::read_config(file); }},
      {"view.json",
       [](const fs::path& file, int version) {
         picture::Camera camera;
         camera.bearing = version;
         io::write_camera(file, camera);
       },
       [](const fs::path& file) { io::read_camera(file); }},
      {"settings.json",
       [](const fs::path& file, int version) { session::write_settings(file.parent_path(), settings_of(version)); },
       [](const fs::path& file) {
         std::string complaint;
         session::read_settings(file.parent_path(), complaint);
         EXPECT_EQ(complaint, "");
       }},
      {"section.csv",
       [](const fs::path& file, int version) {
         const double place = version;
         session::write_section(
             file, {.from = {}, .to = {}, .distance = {place, 1}, .bedrock = {0, 0}, .surface = {1, 2}}, {});
       },
       [](const fs::path& file) { EXPECT_TRUE(read_bytes(file).ends_with("\n1,0,2\n")) << read_bytes(file); }}};
  for (const session::ExportFormat& format : session::export_formats()) {
    all.push_back({"export-" + format.key + format.ending,
                   [key = format.key](const fs::path& file, int version) {
                     session::export_run(file, key, snapshots[static_cast<std::size_t>(version)].runs.front(), {});
                   },
                   [](const fs::path& file) { EXPECT_GT(fs::file_size(file), 0u); }});
  }
  return all;
}

/// Names and contents of the files in a folder.
std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) all[entry.path().string()] = read_bytes(entry.path());
  }
  return all;
}

[[noreturn]] void write_for_ever(const std::vector<Writer>& all, const fs::path& folder) {
  for (int version = 1;; version = 1 - version) {
    for (const Writer& writer : all) writer.write(folder / writer.name, version);
  }
}

TEST(WindowFiles, AKillInTheMiddleOfAnySaveLeavesTheOldFileOrTheNew) {
  const TemporaryFolder folder;
  const std::vector<Writer> all = writers();
  std::map<std::string, std::string> whole[2];
  for (const int version : {0, 1}) {
    for (const Writer& writer : all) {
      writer.write(folder / writer.name, version);
      whole[version][writer.name] = read_bytes(folder / writer.name);
    }
  }
  for (const auto pause : {1ms, 3ms, 5ms, 8ms, 13ms, 21ms, 34ms}) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) write_for_ever(all, folder.path());
    std::this_thread::sleep_for(pause);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    for (const Writer& writer : all) {
      SCOPED_TRACE(writer.name);
      const std::string now = read_bytes(folder / writer.name);
      EXPECT_TRUE(now == whole[0][writer.name] || now == whole[1][writer.name]) << now.size() << " bytes";
      writer.check(folder / writer.name);
    }
  }
}

TEST(WindowFiles, AFullDiskIsSaidWithTheFileAndLeavesTheOldOne) {
  const TemporaryFolder folder;
  for (const Writer& writer : writers()) {
    SCOPED_TRACE(writer.name);
    const fs::path file = folder / writer.name;
    writer.write(file, 0);
    const auto before = contents(folder.path());
    const LimitRestored restored(RLIMIT_FSIZE);
    const SignalIgnored ignored(SIGXFSZ);
    limit_files(before.at(file.string()).size() / 2);
    try {
      writer.write(file, 1);
      ADD_FAILURE() << "wrote onto a full disk";
    } catch (const WriteError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(file.string() + ": cannot write this file (File too large)"))
          << error.what();
    }
    EXPECT_EQ(contents(folder.path()), before);
  }
}

TEST(WindowFiles, AFolderThatMayNotBeWrittenIsSaidWithTheFile) {
  const TemporaryFolder folder;
  for (const Writer& writer : writers()) writer.write(folder / writer.name, 0);
  const auto before = contents(folder.path());
  fs::permissions(folder.path(),
                  fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read | fs::perms::others_exec);
  {
    const OrdinaryUser user;
    for (const Writer& writer : writers()) {
      SCOPED_TRACE(writer.name);
      try {
        writer.write(folder / writer.name, 1);
        ADD_FAILURE() << "wrote without permission";
      } catch (const WriteError& error) {
        const std::string what = error.what();
        EXPECT_TRUE(what.starts_with((folder / writer.name).string() + ": cannot write this file (Permission denied)"))
            << what;
      }
    }
  }
  fs::permissions(folder.path(), fs::perms::owner_all);
  EXPECT_EQ(contents(folder.path()), before);
}

TEST(WindowFiles, ASessionThatNoLongerFitsKeepsWhatItHadSaved) {
  const TemporaryFolder folder;
  Session session(folder.path());
  session.save(snapshot_of(1));
  const auto later = std::make_shared<const Snapshot>(snapshot_of(3));
  {
    const LimitRestored restored(RLIMIT_FSIZE);
    const SignalIgnored ignored(SIGXFSZ);
    limit_files(4000);
    EXPECT_THROW(session.save(snapshot_of(2)), WriteError);
    session.save_if_due(later, 1e-9);
    std::string problem;
    while (problem.empty()) {
      session.save_if_due(later, 0);  // only looks after the save under way: the limit goes when that one has ended
      problem = session.take_problem();
    }
    EXPECT_NE(problem.find(".checkpoint: cannot write this file (File too large)"), std::string::npos) << problem;
  }
  const session::CrashedSession left{.folder = session.folder(), .title = {}, .saved_at = {}, .step = 0, .runs = 1};
  const std::vector<Saved> saved = Session::recover(left);
  ASSERT_EQ(saved.size(), 1u);
  EXPECT_EQ(saved[0].config.run.integer("seed"), 1);
  // There is room again: it is saved though nothing has changed since.
  while (!fs::exists(session.folder() / "run1-3.checkpoint")) {
    session.save_if_due(later, 1e-9);
    ASSERT_EQ(session.take_problem(), "");
  }
}

struct ShortMemory : testing::Test {
  TemporaryFolder folder;
  session::AppModel app{session::AppFolders{folder / "settings", folder / "state", {}}};

  void SetUp() override {
    app.setup().replace(small_config());
    ASSERT_TRUE(app.create());
    settle();
    app.runner().step();
    settle();
  }
  void settle() {
    app.runner().wait_until_still();
    app.tick();
  }
  void expect_the_small_terrain() {
    ASSERT_EQ(app.now().runs.size(), 1u);
    EXPECT_EQ(app.now().runs[0].terrain->nx(), 48);
    EXPECT_EQ(app.now().step(), 1);
    EXPECT_EQ(app.now().activity, Activity::paused);
  }
};

Config huge() {
  Config config = small_config();
  config.grid.set("nx", std::int64_t{16384});
  config.grid.set("ny", std::int64_t{16384});
  return config;
}

TEST_F(ShortMemory, AHugeTerrainIsRefusedInTheLogAndWhatWasThereStays) {
  const LimitRestored restored(RLIMIT_AS);
  limit_memory(rlim_t{600} << 20);
  app.setup().replace(huge());
  EXPECT_TRUE(app.create());
  settle();
  expect_the_small_terrain();
  const std::string log = app.log().text(LogLevel::error);
  EXPECT_NE(log.find("grid: 16384 x 16384 cells need "), std::string::npos) << log;
  EXPECT_NE(log.find(" would fit"), std::string::npos) << log;
  EXPECT_EQ(log.find("bad_alloc"), std::string::npos) << log;
  app.runner().step();
  settle();
  EXPECT_EQ(app.now().step(), 2);
}

TEST_F(ShortMemory, OpeningAHugeConfigKeepsWhatWasOpen) {
  write_config(folder / "huge.json", huge());
  const LimitRestored restored(RLIMIT_AS);
  limit_memory(rlim_t{600} << 20);
  app.open(folder / "huge.json");
  settle();
  expect_the_small_terrain();
  EXPECT_EQ(app.setup().config().grid.integer("nx"), 48);
  EXPECT_TRUE(app.file().empty());
}

TEST_F(ShortMemory, AComparisonThatDoesNotFitIsRefusedWhereEachRunAloneWouldFit) {
  Config large = small_config();
  for (const char* side : {"nx", "ny"}) large.grid.set(side, std::int64_t{4096});
  const std::array one{large};
  const std::array four{large, large, large, large};
  const std::uint64_t free = std::uint64_t{1} << 30;
  EXPECT_NO_THROW(check_memory(one, 2, free));
  EXPECT_THROW(check_memory(four, 2, free), InputError);
  const LimitRestored restored(RLIMIT_AS);
  limit_memory(rlim_t{600} << 20);
  app.setup().replace(huge());
  app.comparison().add_copy_of(0);
  EXPECT_TRUE(app.create());
  settle();
  expect_the_small_terrain();
  EXPECT_GT(app.log().count(LogLevel::error), 0u);
}

TEST_F(ShortMemory, ASavedRunThatFitsWithoutItsCopiesOnlyIsRefused) {
  Config large = small_config();
  for (const char* side : {"nx", "ny"}) large.grid.set(side, std::int64_t{4096});
  std::vector<Saved> saved;
  saved.push_back({large, io::start_simulation(large).state()});
  const LimitRestored restored(RLIMIT_AS);
  limit_memory(rlim_t{550} << 20);
  EXPECT_NO_THROW(check_memory({&large, 1}, 0, sim::free_memory()));
  app.runner().resume(std::move(saved));
  settle();
  expect_the_small_terrain();
  EXPECT_NE(app.log().text(LogLevel::error).find("grid: 4096 x 4096 cells need "), std::string::npos)
      << app.log().text();
}

TEST(Runner, AStepWithoutMemoryIsSaidInWordsAndTheRunsStandAsTheyWere) {
  session::Log log;
  bool memory = true;
  Runner runner(log, [&memory] {
    if (!memory) throw std::bad_alloc();
  });
  runner.create({small_config()});
  runner.run(3);
  runner.wait_until_still();
  const std::uint64_t before = state_hash(*runner.snapshot()->runs[0].terrain);
  memory = false;
  runner.step();
  runner.wait_until_still();
  EXPECT_EQ(runner.snapshot()->activity, Activity::failed);
  EXPECT_EQ(state_hash(*runner.snapshot()->runs[0].terrain), before);
  EXPECT_NE(log.text().find("a step failed: there is not enough memory"), std::string::npos) << log.text();
  EXPECT_EQ(log.text().find("bad_alloc"), std::string::npos);
}

}  // namespace
}  // namespace erg::test::trust
