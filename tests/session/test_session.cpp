// The session that is saved by itself: nothing is lost to a crash, even one in the middle of saving.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "../unit/message.h"
#include "../unit/mutated.h"
#include "../unit/temporary_folder.h"
#include "session/app_model.h"
#include "session/runner.h"
#include "session/session.h"
#include "small_config.h"
#include "snapshot_of.h"
#include "torn_session.h"

namespace erg {

using io::Saved;
using io::write_checkpoint;
using session::AppModel;
using session::CrashedSession;
using session::Session;
using session::Snapshot;
using sim::Config;
using sim::Simulation;

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using test::small_config;
using test::snapshot_of;

Config titled(int seed) {
  Config config = small_config("serial", seed);
  config.title = "left behind";
  return config;
}

std::uint64_t straight_hash(const Config& config, std::int64_t steps) {
  Simulation simulation(config);
  for (std::int64_t step = 0; step < steps; ++step) simulation.step();
  return state_hash(simulation.terrain());
}

/// What a program does that saves after every step until it is killed.
[[noreturn]] void step_and_save(const fs::path& folder) {
  Session session(folder);
  Simulation simulation(titled(5));
  for (std::uint64_t number = 1;; ++number) {
    simulation.step();
    session.save(snapshot_of(simulation, number));
  }
}

/// Ends a session as a crash would, one save done.
void leave_behind(const fs::path& folder) {
  Session session(folder);
  Simulation simulation(titled(1));
  session.save(snapshot_of(simulation, 1));
  session.keep();
}

TEST(Session, AKillAtAnyMomentLosesNothing) {
  for (const auto pause : {0ms, 7ms, 20ms}) {
    const TemporaryFolder folder;
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) step_and_save(folder.path());
    const auto saved_once = [&] { return fs::exists(folder / ("session-" + std::to_string(child)) / "session.json"); };
    while (!saved_once()) std::this_thread::sleep_for(1ms);
    EXPECT_TRUE(Session::lost(folder.path()).empty()) << "its program lives";
    std::this_thread::sleep_for(pause);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const std::vector<CrashedSession> lost = Session::lost(folder.path());
    ASSERT_EQ(lost.size(), 1u);
    EXPECT_EQ(lost[0].title, "left behind");
    EXPECT_EQ(lost[0].runs, 1u);
    const std::vector<Saved> runs = Session::recover(lost[0]);
    ASSERT_EQ(runs.size(), 1u);
    EXPECT_EQ(runs[0].state.step, lost[0].step);
    EXPECT_EQ(state_hash(runs[0].state.terrain), straight_hash(titled(5), lost[0].step));
    Session::discard(lost[0]);
    EXPECT_TRUE(Session::lost(folder.path()).empty());
    EXPECT_TRUE(fs::is_empty(folder.path()));
  }
}

TEST(Session, AnOrderlyEndLeavesNothing) {
  const TemporaryFolder folder;
  {
    Session session(folder.path());
    Simulation simulation(titled(1));
    session.save(snapshot_of(simulation, 1));
    EXPECT_TRUE(fs::exists(session.folder() / "session.json"));
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(Session, AKeptOneIsFound) {
  const TemporaryFolder folder;
  leave_behind(folder.path());
  EXPECT_EQ(Session::lost(folder.path()).size(), 1u);
}

TEST(Session, OneThatSavedNothingIsNotOffered) {
  const TemporaryFolder folder;
  { Session(folder.path()).keep(); }
  EXPECT_TRUE(Session::lost(folder.path()).empty());
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(Session, SavesInTheBackgroundWhenItIsTimeAndSomethingChanged) {
  const TemporaryFolder folder;
  Session session(folder.path());
  Simulation simulation(titled(1));
  const auto first = std::make_shared<const Snapshot>(snapshot_of(simulation, 1));
  const auto saved = session.folder() / "session.json";
  session.save_if_due(first, 0);
  session.save_if_due(first, 60);
  EXPECT_FALSE(fs::exists(saved)) << "never, or not yet";
  while (!fs::exists(saved)) session.save_if_due(first, 1e-9);
  EXPECT_EQ(session.take_problem(), "");
  const auto second = std::make_shared<const Snapshot>(snapshot_of(simulation, 2));
  while (!fs::exists(session.folder() / "run1-2.checkpoint")) session.save_if_due(second, 1e-9);
}

TEST(Session, AFolderThatCannotBeWrittenIsSaid) {
  const TemporaryFolder folder;
  write_bytes(folder / "file", "");
  EXPECT_THROW(Session(folder / "file"), InputError);
}

TEST(Session, ADamagedCheckpointIsRefused) {
  const TemporaryFolder folder;
  leave_behind(folder.path());
  const std::vector<CrashedSession> lost = Session::lost(folder.path());
  ASSERT_EQ(lost.size(), 1u);
  const fs::path checkpoint = lost[0].folder / "run1-1.checkpoint";
  std::string bytes = read_bytes(checkpoint);
  bytes[bytes.size() / 2] ^= 1;
  write_bytes(checkpoint, bytes);
  EXPECT_THROW(Session::recover(lost[0]), InputError);
}

TEST(Session, ADamagedListLosesNoCheckpoint) {
  const TemporaryFolder folder;
  leave_behind(folder.path());
  const fs::path left = Session::lost(folder.path()).front().folder;
  const std::string list = read_bytes(left / "session.json");
  const std::string checkpoint = read_bytes(left / "run1-1.checkpoint");
  for (const std::string& damaged : {std::string(), list.substr(0, list.size() / 2), std::string(list.size(), '\0')}) {
    write_bytes(left / "session.json", damaged);
    const std::vector<CrashedSession> lost = Session::lost(folder.path());
    ASSERT_EQ(lost.size(), 1u);
    EXPECT_EQ(lost[0].runs, 1u);
    EXPECT_EQ(read_bytes(left / "run1-1.checkpoint"), checkpoint);
    const std::vector<Saved> runs = Session::recover(lost[0]);
    ASSERT_EQ(runs.size(), 1u);
    EXPECT_EQ(runs[0].config.title, "left behind");
  }
}

TEST(Session, AMissingListIsOfferedByItsCheckpoints) {
  const TemporaryFolder folder;
  leave_behind(folder.path());
  const fs::path left = Session::lost(folder.path()).front().folder;
  fs::remove(left / "session.json");
  // A later save of two runs, and one that a person put there.
  Simulation simulation(titled(2));
  for (int step = 0; step < 3; ++step) simulation.step();
  const std::string newer = "run1-12.checkpoint";
  write_checkpoint(left / newer, simulation.config(), simulation.state());
  write_checkpoint(left / "run2-12.checkpoint", simulation.config(), simulation.state());
  write_checkpoint(left / "mine-99.checkpoint", titled(3), Simulation(titled(3)).state());
  const std::vector<CrashedSession> lost = Session::lost(folder.path());
  ASSERT_EQ(lost.size(), 1u);
  EXPECT_EQ(lost[0].runs, 2u);
  EXPECT_NE(lost[0].saved_at, "(unknown)");
  const std::vector<Saved> runs = Session::recover(lost[0]);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].state.step, 3);
  for (const char* const name : {"run1-12.checkpoint", "run2-12.checkpoint", "run1-1.checkpoint"}) {
    fs::remove(left / name);
  }
  EXPECT_EQ(Session::recover(Session::lost(folder.path()).front()).size(), 1u) << "by whatever name";
  fs::remove(left / "mine-99.checkpoint");
  EXPECT_TRUE(Session::lost(folder.path()).empty());
  EXPECT_FALSE(fs::exists(left)) << "nothing was in it";
}

TEST(Session, WhereNoneCanBeKeptIsSaid) {
  AppModel homeless({{}, {}, {}});
  EXPECT_NE(homeless.why_not_kept().find("XDG_STATE_HOME"), std::string::npos);
  EXPECT_EQ(homeless.rescue(), "there was nothing to save");
  homeless.setup().set("grid", "nx", std::int64_t{2048});
  homeless.setup().set("grid", "ny", std::int64_t{2048});
  homeless.create();
  EXPECT_EQ(homeless.rescue(), "the terrain was still being made; nothing was saved");
  homeless.setup().replace(titled(1));
  ASSERT_TRUE(homeless.create());
  homeless.runner().wait_for_commands();
  EXPECT_TRUE(homeless.rescue().starts_with("the runs are lost")) << homeless.rescue();
  const TemporaryFolder folder;
  AppModel housed({{}, folder.path(), {}});
  EXPECT_EQ(housed.why_not_kept(), "");
}

TEST(Session, AMutatedListIsOfferedAndNothingIsLost) {
  const TemporaryFolder folder;
  leave_behind(folder.path());
  const fs::path left = Session::lost(folder.path()).front().folder;
  const std::string list = read_bytes(left / "session.json");
  test::Mutator mutator(1);
  for (int number = 0; number < test::mutations(200); ++number) {
    write_bytes(left / "session.json", mutator.of(list));
    const std::vector<CrashedSession> lost = Session::lost(folder.path());
    ASSERT_EQ(lost.size(), 1u) << number;
    message([&] { Session::recover(lost[0]); });
  }
  EXPECT_TRUE(fs::exists(left / "run1-1.checkpoint"));
}

TEST(Session, OneWhoseRunsCannotBeMadeStaysOnOffer) {
  const TemporaryFolder folder;
  test::leave_torn_session(folder.path(), titled(1));
  AppModel app({{}, folder.path(), {}});
  ASSERT_EQ(app.crashed_sessions().size(), 1u);
  const fs::path lost = app.crashed_sessions().front().folder;
  EXPECT_TRUE(app.recover(lost)) << "it can be read";
  app.runner().wait_until_still();
  app.tick();
  EXPECT_EQ(app.now().activity, session::Activity::empty) << "runs of one comparison stand at one step";
  EXPECT_GE(app.log().count(session::LogLevel::error), 1u);
  EXPECT_EQ(app.setup().config(), Config());
  EXPECT_TRUE(app.take_failed_creation());
  EXPECT_FALSE(app.take_failed_creation()) << "told once";
  EXPECT_EQ(app.crashed_sessions().size(), 1u);
  app.rescue();
  EXPECT_TRUE(fs::exists(lost / "session.json"));
}

}  // namespace
}  // namespace erg
