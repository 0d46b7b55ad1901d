// Every output is tried before the first step; a run that fails later is saved; runs do not mix their files.
#include <grp.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "../unit/limits.h"
#include "io/checkpoint/checkpoint.h"
#include "io/config/config_file.h"
#include "program.h"

namespace erg::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

// So many that a test would not end if they were run.
constexpr int endless = 1'000'000'000;

using Words = std::vector<std::string>;

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Refused at once, in one line that has `said` in it.
void expect_refused(const ScratchFolder& folder, const Words& words, const std::string& said,
                    const std::function<void()>& in_child = {}) {
  SCOPED_TRACE(said);
  const Ended ended = run_erg(folder, words, in_child);
  EXPECT_EQ(ended.exit_code, 2) << ended.errors;
  EXPECT_NE(ended.errors.find(said), std::string::npos) << ended.errors;
  EXPECT_LT(ended.errors.size(), 500u) << ended.errors;
}

/// In the child: a user to whom permissions mean something.
void become_ordinary() {
  if (::geteuid() == 0 && (::setgroups(0, nullptr) != 0 || ::setgid(65534) != 0 || ::setuid(65534) != 0)) _exit(125);
}

TEST(Outputs, AFolderThatMayNotBeWrittenIsFoundBeforeTheRun) {
  const ScratchFolder folder;
  const std::string config = folder.write("small.json", small_config(endless));
  fs::create_directory(folder.file("closed"));
  fs::permissions(folder.path(), fs::perms::owner_all | fs::perms::others_read | fs::perms::others_exec);
  fs::permissions(folder.file("closed"),
                  fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read | fs::perms::others_exec);
  const auto refused = [&](const Words& more, const std::string& file) {
    expect_refused(folder, with({"run", config, "--quiet"}, more),
                   file + ": cannot write this file (Permission denied)", become_ordinary);
  };
  refused({"--out", "closed", "--format", "checkpoint"}, "closed/small-1000000000.checkpoint");
  refused({"--out", "closed", "--format", "csv"}, "closed/small-1000000000.checkpoint");
  refused({"--stats", "closed/numbers.json"}, "--stats closed/numbers.json");
  expect_refused(folder, {"run", config, "--out", "closed/deeper"}, "closed/deeper: cannot make this folder",
                 become_ordinary);
  expect_refused(folder, {"render", config, "--out", "closed/p.png"}, "--out closed/p.png: cannot write this file",
                 become_ordinary);
  expect_refused(folder, {"validate", "--out", "closed/v.md"}, "--out closed/v.md: cannot write this file",
                 become_ordinary);
  EXPECT_TRUE(fs::is_empty(folder.file("closed")));
}

TEST(Outputs, AFolderInAFilesPlaceAndANameTooLongAreFoundBeforeTheRun) {
  const ScratchFolder folder;
  const std::string config = folder.write("small.json", small_config(endless));
  fs::create_directories(folder.file("d"));
  fs::create_directories(folder.file("out/small-1000000000.vti"));
  const std::string is_folder = "cannot write this file (Is a directory); it is a folder; give the name of a file";
  expect_refused(folder, {"run", config, "--stats", "d"}, "--stats d: " + is_folder);
  expect_refused(folder, {"run", config, "--format", "vti"}, "out/small-1000000000.vti: " + is_folder);
  expect_refused(folder, {"render", config, "--out", "d"}, "--out d: " + is_folder);
  expect_refused(folder, {"validate", "--out", "d"}, "--out d: " + is_folder);
  const std::string name(236, 'a');
  folder.write(name + ".json", small_config(endless));
  expect_refused(folder, {"run", name + ".json", "--format", "checkpoint"},
                 "(File name too long); give a shorter name");
  expect_refused(folder, {"run", config, "--stats", std::string(300, 'b')}, "(File name too long)");
  fs::create_symlink("loop", folder.file("loop"));
  expect_refused(folder, {"run", config, "--stats", "loop"}, "--stats loop: cannot write this file");
}

TEST(Outputs, NumbersMayLieInTheFolderThatTheRunMakes) {
  const ScratchFolder folder;
  folder.write("small.json", small_config(1));
  const Words run{"run", "small.json", "--quiet", "--format", "checkpoint"};
  EXPECT_EQ(run_erg(folder, with(run, {"--out", "o", "--stats", "o/numbers.json"})).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder.file("o/numbers.json")));
  EXPECT_EQ(run_erg(folder, with(run, {"--out", "./p/q/", "--stats", "p/numbers.json"})).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder.file("p/numbers.json")));
  expect_refused(folder, with(run, {"--out", "r", "--stats", "r/s/numbers.json"}), "there is no folder r/s");
  EXPECT_FALSE(fs::exists(folder.file("r")));
}

TEST(Outputs, AFilmHasAFewPixels) {
  const ScratchFolder folder;
  folder.write("small.json", small_config(endless));
  expect_refused(folder, {"run", "small.json", "--frames", "1", "--size", "1x1"},
                 "--size 1x1: is too small for a film");
  EXPECT_FALSE(fs::exists(folder.file("out/small-frames")));
}

TEST(Outputs, AFilmOfAnyNameIsAskedFor) {
  const ScratchFolder folder;
  // Stands in for ffmpeg: the word after -i is where it looks for frames, the last one is the film.
  folder.write(
      "ffmpeg",
      "#!/bin/sh\nwhile [ $# -gt 1 ]; do [ \"$1\" = -i ] && echo \"$2\" > asked.txt; shift; done\n: > \"$1\"\n");
  fs::permissions(folder.path() / "ffmpeg", fs::perms::owner_all);
  const std::string name = "100%d -x: $y";
  folder.write(name + ".json", small_config(1));
  const Ended ended =
      run_erg(folder, {"run", name + ".json", "--frames", "1", "--size", "48x32", "--quiet", "--out", "o%3d"},
              [path = folder.path().string() + ":" + std::getenv("PATH")] { setenv("PATH", path.c_str(), 1); });
  ASSERT_EQ(ended.exit_code, 0) << ended.errors;
  EXPECT_TRUE(fs::exists(folder.path() / "o%3d" / (name + ".mp4")));
  EXPECT_EQ(read_bytes(folder.file("asked.txt")),
            (folder.path() / "o%%3d" / "100%%d -x: $y-frames" / "%06d.png").string() + "\n");
}

// --- failing on the way ---

/// Snow that rises higher than is counted after some hundred steps.
std::string deep_snow() {
  sim::Config config("snow_sintering");
  config.grid.set("nx", std::int64_t{16});
  config.grid.set("ny", std::int64_t{16});
  config.parameters.set("slab_height", 0.001);
  config.parameters.set("time_step", 3600.0);
  config.parameters.set("snowfall", 200.0);
  config.run.set("steps", std::int64_t{1000});
  return io::config_text(config);
}

/// The command after "Go on with: erg ", as a shell takes it apart.
Words way_on(const ScratchFolder& folder, const std::string& errors) {
  const std::string before = "Go on with: erg ";
  const std::size_t at = errors.find(before);
  if (at == std::string::npos) return {};
  const std::string command = errors.substr(at + before.size(), errors.find('\n', at) - at - before.size());
  folder.write("words.sh", "for word in " + command + "; do printf '%s\\n' \"$word\"; done\n");
  std::system(("sh " + folder.file("words.sh") + " > " + folder.file("words.txt")).c_str());
  std::istringstream lines(read_bytes(folder.file("words.txt")));
  Words words;
  for (std::string line; std::getline(lines, line);) words.push_back(line);
  return words;
}

TEST(FailsOnTheWay, SnowTooHighLeavesWhatWasReachedAndTheWayOn) {
  const ScratchFolder folder;
  folder.write("deep.json", deep_snow());
  const Ended ended = run_erg(folder, {"run", "deep.json", "--out", "my $x", "--format", "vti", "--quiet"});
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_TRUE(ended.errors.starts_with("terrain: it is ")) << ended.errors;
  const Words words = way_on(folder, ended.errors);
  ASSERT_GE(words.size(), 3u) << ended.errors;
  const io::Saved saved = io::read_checkpoint(folder.path() / words[2]);
  EXPECT_GT(saved.state.step, 10);
  // The state is that of a run which ended there.
  const std::string steps = std::to_string(saved.state.step);
  const std::string whole = run_erg(folder, {"run", "deep.json", "--steps", steps, "--quiet", "--hash"}).output;
  EXPECT_EQ(whole, run_erg(folder, with(words, {"--steps", steps, "--quiet", "--hash"})).output);
  // It can go on where less falls.
  const std::string more = std::to_string(saved.state.step + 3);
  EXPECT_EQ(run_erg(folder, with(words, {"--steps", more, "--set", "snowfall=0", "--quiet"})).exit_code, 2)
      << "it is as high as that already";
}

TEST(FailsOnTheWay, AFileThatDoesNotFitDoesNotTakeTheRunWithIt) {
  const ScratchFolder folder;
  folder.write("it's.json", small_config(100));
  const Ended ended =
      run_erg(folder, {"run", "it's.json", "--every", "40", "--format", "obj", "--out", "a b", "--quiet"},
              [] { limit_files(60000); });
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_TRUE(ended.errors.starts_with("a b/it's-000040.obj: cannot write this file (File too large)")) << ended.errors;
  const Words words = way_on(folder, ended.errors);
  ASSERT_GE(words.size(), 3u) << ended.errors;
  EXPECT_EQ(words[2], "a b/it's-000040.checkpoint");
  const Ended resumed = run_erg(folder, with(words, {"--quiet", "--hash"}));
  ASSERT_EQ(resumed.exit_code, 0) << resumed.errors;
  EXPECT_TRUE(fs::exists(folder.path() / "a b" / "it's-000080.obj")) << "the outputs asked for go on too";
  EXPECT_EQ(resumed.output, run_erg(folder, {"run", "it's.json", "--quiet", "--hash"}).output);
}

TEST(FailsOnTheWay, WhereNothingCanBeSavedThatIsSaid) {
  const ScratchFolder folder;
  folder.write("small.json", small_config(10));
  const Ended ended =
      run_erg(folder, {"run", "small.json", "--every", "5", "--format", "vti", "--quiet"}, [] { limit_files(2000); });
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_NE(ended.errors.find("after step 5 of 10. Nothing could be saved."), std::string::npos) << ended.errors;
}

// --- tables ---

TEST(Outputs, OfTwoRunsAtOnceAreNotMixed) {
  const ScratchFolder folder;
  folder.write("small.json", small_config(endless));
  folder.write("other.json", small_config(2));
  const Words files{"--every", "1000000", "--format", "checkpoint", "--quiet"};
  Program first(folder, with({"run", "small.json"}, files));
  const std::string held = folder.file("out/.small.part-erg");
  for (int i = 0; i < 3000 && !fs::exists(held); ++i) std::this_thread::sleep_for(10ms);
  std::this_thread::sleep_for(50ms);
  const Words second = with({"run", "small.json", "--steps", "2"}, files);
  expect_refused(folder, second, "out/small: another run is writing files of this name");
  EXPECT_EQ(run_erg(folder, with({"run", "other.json"}, files)).exit_code, 0) << "which has a name of its own";
  first.send(SIGINT);
  EXPECT_EQ(first.wait().exit_code, 1);
  EXPECT_FALSE(fs::exists(held));
  // One that was killed left its file.
  folder.write("out/.small.part-erg", "");
  EXPECT_EQ(run_erg(folder, second).exit_code, 0);
}

TEST(Tables, OfTwoRunsAtOnceAreNotMixed) {
  const ScratchFolder folder;
  folder.write("small.json", small_config(endless));
  const Words run{"run", "small.json", "--every", "20", "--format", "csv", "--quiet"};
  Program first(folder, with(run, {"--seed", "1"}));
  for (int i = 0; i < 3000 && !fs::exists(folder.file("out/small.csv")); ++i) std::this_thread::sleep_for(10ms);
  std::this_thread::sleep_for(50ms);
  expect_refused(folder, with(run, {"--seed", "2"}), "out/small: another run is writing files of this name");
  first.send(SIGINT);
  EXPECT_EQ(first.wait().exit_code, 1);
  std::istringstream lines(read_bytes(folder.file("out/small.csv")));
  double last = -1;
  int rows = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#') || line.starts_with("step")) continue;
    EXPECT_GT(std::stod(line), last);
    last = std::stod(line);
    ++rows;
  }
  EXPECT_GT(rows, 0);
}

TEST(Tables, OfAnotherRunAreNotGoneOnWith) {
  const ScratchFolder folder;
  folder.write("small.json", small_config(20));
  const Words files{"--format", "csv,checkpoint", "--every", "10", "--quiet"};
  ASSERT_EQ(run_erg(folder, with({"run", "small.json", "--seed", "1", "--out", "a"}, files)).exit_code, 0);
  ASSERT_EQ(run_erg(folder, with({"run", "small.json", "--seed", "2", "--out", "b"}, files)).exit_code, 0);
  const std::string before = read_bytes(folder.file("b/small.csv"));
  expect_refused(folder, with({"run", "--resume", "a/small-000010.checkpoint", "--out", "b"}, files),
                 "b/small.csv: holds the rows of another run: seed is 2 there and 1 here");
  EXPECT_EQ(read_bytes(folder.file("b/small.csv")), before);
  EXPECT_EQ(run_erg(folder, with({"run", "--resume", "a/small-000010.checkpoint", "--out", "a"}, files)).exit_code, 0);
}

}  // namespace
}  // namespace erg::test
