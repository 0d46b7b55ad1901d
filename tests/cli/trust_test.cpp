// What may happen to a run from outside: it is killed, the disk is full, the memory is short. Nothing that was saved is
// lost, and the error says what to do.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

#include "../unit/limits.h"
#include "io/checkpoint/checkpoint.h"
#include "io/config/config_file.h"
#include "io/formats/png_reader.h"
#include "program.h"
#include "sim/memory.h"

namespace erg::test {

using io::read_checkpoint;
using sim::Config;

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

std::size_t lines_with(const std::string& text, const std::string& start) {
  std::size_t count = text.starts_with(start) ? 1 : 0;
  for (std::size_t at = 0; (at = text.find("\n" + start, at)) != std::string::npos; ++at) ++count;
  return count;
}

/// Every row has as many values as the header, and the last one its end.
void expect_whole_table(const std::string& text) {
  ASSERT_TRUE(text.ends_with('\n'));
  std::ptrdiff_t commas = -1;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    const std::ptrdiff_t here = std::count(line.begin(), line.end(), ',');
    if (commas < 0) commas = here;
    EXPECT_EQ(here, commas) << line;
  }
  EXPECT_GT(commas, 0) << "there is a header";
}

/// Throws or fails where a file is not what its name says.
void expect_whole(const fs::path& path) {
  SCOPED_TRACE(path.filename().string());
  const std::string kind = path.extension();
  const std::string text = read_bytes(path);
  if (kind == ".checkpoint") {
    EXPECT_NO_THROW(read_checkpoint(path));
  } else if (kind == ".png") {
    EXPECT_NO_THROW(io::PngReader(path).read_rows([](int, std::span<const std::uint16_t>) {}));
  } else if (kind == ".json") {
    EXPECT_NO_THROW(read_json(path));
  } else if (kind == ".csv") {
    expect_whole_table(text);
  } else if (kind == ".vti") {
    EXPECT_TRUE(text.ends_with("</AppendedData>\n</VTKFile>\n"));
  } else if (kind == ".obj") {
    EXPECT_EQ(lines_with(text, "v "), 48u * 32);
    EXPECT_EQ(lines_with(text, "f "), 2u * 47 * 31);
    EXPECT_TRUE(text.ends_with('\n'));
  } else if (kind == ".ply") {
    const std::size_t header = text.find("end_header\n");
    ASSERT_NE(header, std::string::npos);
    EXPECT_EQ(text.size(), header + 11 + 48 * 32 * 16 + 2 * 47 * 31 * 13);
  } else if (kind == ".stl") {
    std::uint32_t triangles = 0;
    ASSERT_GT(text.size(), 84u);
    std::memcpy(&triangles, text.data() + 80, sizeof triangles);
    EXPECT_EQ(text.size(), 84 + std::size_t{50} * triangles);
  } else {
    ADD_FAILURE() << "an unexpected file";
  }
}

/// The files under the names that the program gives; not those that a killed writer left unfinished beside them.
std::vector<fs::path> finished_files(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const bool unfinished = entry.path().filename().string().find(".part") != std::string::npos;
    if (entry.is_regular_file() && !unfinished) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

const std::vector<std::string>& every_format() {
  static const std::vector<std::string> all{"png", "png16", "vti", "csv", "checkpoint", "obj", "ply", "stl"};
  return all;
}

TEST(Killed, ARunLeavesWholeFilesAndEverythingThatItHadSaved) {
  for (const auto pause : {0ms, 11ms, 37ms, 120ms}) {
    const ScratchFolder folder;
    const std::string config = folder.write("small.json", small_config(1000000));
    Program program(folder, {"run", config, "--every", "1", "--format", "png,png16,vti,csv,checkpoint,obj,ply,stl",
                             "--frames", "7", "--size", "48x32", "--quiet"});
    for (int i = 0; i < 3000 && !fs::exists(folder.file("out/small-000002.checkpoint")); ++i) {
      std::this_thread::sleep_for(10ms);
    }
    std::this_thread::sleep_for(pause);
    program.send(SIGKILL);
    ASSERT_EQ(program.wait().exit_code, -1) << "it was killed";
    std::int64_t last = 0;
    for (const fs::path& file : finished_files(folder.file("out"))) {
      expect_whole(file);
      if (file.extension() != ".checkpoint") continue;
      const std::int64_t step = read_checkpoint(file).state.step;
      EXPECT_EQ(step, last + 1) << "one after another, none is missing";
      last = step;
    }
    EXPECT_GE(last, 2);
  }
}

TEST(Killed, ARunGoesOnToTheSameBitsAndTheSameTable) {
  const ScratchFolder folder;
  const std::string config = folder.write("small.json", small_config(1000000));
  const std::vector<std::string> common{"--format", "csv,checkpoint", "--every", "1", "--quiet", "--hash"};
  const auto with = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), common.begin(), common.end());
    return arguments;
  };
  Program program(folder, with({"run", config}));
  for (int i = 0; i < 3000 && !fs::exists(folder.file("out/small-000009.checkpoint")); ++i) {
    std::this_thread::sleep_for(10ms);
  }
  program.send(SIGKILL);
  program.wait();
  const Ended resumed =
      run_erg(folder, with({"run", "--resume", "out/small-000009.checkpoint", "--out", "out", "--steps", "12"}));
  const Ended whole = run_erg(folder, with({"run", config, "--out", "whole", "--steps", "12"}));
  ASSERT_EQ(resumed.exit_code, 0) << resumed.errors;
  EXPECT_EQ(resumed.output, whole.output);
  // Below the provenance, which tells when each was begun, the tables are the same.
  const auto rows = [&](const std::string& name) {
    const std::string text = read_bytes(folder.file(name));
    return text.substr(text.find("\nstep,"));
  };
  EXPECT_EQ(rows("out/small.csv"), rows("whole/small.csv"));
}

/// What the files of a folder hold.
std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) all[entry.path().string()] = read_bytes(entry.path());
  }
  return all;
}

TEST(FullDisk, ARunNamesTheFileAndLeavesTheOlderOneAsItWas) {
  const ScratchFolder folder;
  folder.write("small.json", small_config(2));
  for (const std::string& format : every_format()) {
    SCOPED_TRACE(format);
    const std::vector<std::string> run{"run", "small.json", "--format", format, "--out", format, "--quiet"};
    ASSERT_EQ(run_erg(folder, run).exit_code, 0);
    const auto before = contents(folder.file(format));
    ASSERT_EQ(before.size(), 1u);
    std::vector<std::string> other = run;
    other.insert(other.end(), {"--seed", "8"});
    const Ended ended = run_erg(folder, other, [] { limit_files(300); });
    EXPECT_EQ(ended.exit_code, 1);
    const std::string name = fs::relative(before.begin()->first, folder.path());
    EXPECT_TRUE(ended.errors.starts_with(name + ": cannot write this file (File too large); ")) << ended.errors;
    EXPECT_EQ(contents(folder.file(format)), before) << "the older file, and nothing beside it";
  }
}

TEST(FullDisk, ATableEndsWithAWholeRowAndTheErrorTellsTheWayOn) {
  const ScratchFolder folder;
  folder.write("small.json", small_config(400));
  // The checkpoints fit, the growing table does not.
  const std::uintmax_t room = 4500;
  const std::vector<std::string> run{"run",     "small.json", "--every", "1",     "--format", "csv,checkpoint",
                                     "--quiet", "--set",      "nx=16",   "--set", "ny=16"};
  const Ended ended = run_erg(folder, run, [] { limit_files(4500); });
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_TRUE(ended.errors.starts_with("out/small.csv: cannot write this file")) << ended.errors;
  expect_whole(folder.file("out/small.csv"));
  EXPECT_LE(fs::file_size(folder.file("out/small.csv")), room);
  const std::size_t way = ended.errors.find("erg run --resume ");
  ASSERT_NE(way, std::string::npos) << ended.errors;
  std::istringstream words(ended.errors.substr(way + std::strlen("erg ")));
  std::vector<std::string> resume;
  for (std::string word; words >> word;) resume.push_back(word);
  resume.insert(resume.end(), {"--quiet", "--hash"});
  const Ended resumed = run_erg(folder, resume);
  ASSERT_EQ(resumed.exit_code, 0) << resumed.errors;
  EXPECT_EQ(resumed.output,
            run_erg(folder, {"run", "small.json", "--set", "nx=16", "--set", "ny=16", "--quiet", "--hash"}).output);
}

TEST(FullDisk, StatisticsPicturesAndFilmsSaySoToo) {
  const ScratchFolder folder;
  folder.write("small.json", small_config(2));
  const auto expect_refused = [&](
                                  const std::vector<std::string>& arguments, const std::string& file,
                                  const std::function<void()>& limit = [] { limit_files(1000); }) {
    const Ended ended = run_erg(folder, arguments, limit);
    EXPECT_EQ(ended.exit_code, 1) << ended.errors;
    EXPECT_NE(ended.errors.find(file + ": "), std::string::npos) << ended.errors;
  };
  // A disk that is really full.
  expect_refused({"run", "small.json", "--quiet", "--stats", "/dev/full"}, "/dev/full", {});
  expect_refused({"run", "small.json", "--quiet", "--stats", "stats.json"}, "stats.json", [] { limit_files(100); });
  expect_refused({"render", "small.json", "--quiet", "--size", "96x64", "--out", "picture.png"}, "picture.png");
  expect_refused({"render", "small.json", "--quiet", "--size", "96x64", "--out", "/dev/full"}, "/dev/full", {});
  expect_refused({"run", "small.json", "--quiet", "--frames", "1", "--size", "96x64"}, "out/small-frames/000000.png");
  // Numbers that could not be written did not take the run with them.
  const std::vector<fs::path> left = finished_files(folder.file("out"));
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left.front().filename(), "small-000002.checkpoint");
  expect_whole(left.front());
}

TEST(FullDisk, AFilmThatFailsLeavesTheOlderFilm) {
  const ScratchFolder folder;
  folder.write("small.json", small_config(1));
  folder.write("ffmpeg", "#!/bin/sh\nfor film; do :; done\necho half > \"$film\"\nexit 1\n");
  fs::permissions(folder.path() / "ffmpeg", fs::perms::owner_all);
  fs::create_directory(folder.path() / "out");
  folder.write("out/small.mp4", "the older film");
  const Ended ended =
      run_erg(folder, {"run", "small.json", "--quiet", "--frames", "1", "--size", "48x32", "--hash"},
              [path = folder.path().string() + ":" + std::getenv("PATH")] { setenv("PATH", path.c_str(), 1); });
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_TRUE(ended.errors.starts_with("out/small.mp4: ")) << ended.errors;
  EXPECT_EQ(ended.output.size(), 17u) << "the run itself was done";
  EXPECT_EQ(read_bytes(folder.file("out/small.mp4")), "the older film");
  EXPECT_EQ(finished_files(folder.file("out")).size(), 3u) << "two frames and the film";
}

TEST(FullDisk, AFolderThatCannotBeIsSaidBeforeTheRun) {
  const ScratchFolder folder;
  folder.write("small.json", small_config(1000000000));
  folder.write("file", "");
  for (const char* out : {"file", "file/below", "/proc/here"}) {
    for (const std::vector<std::string>& way : {std::vector<std::string>{"--every", "5"}, {"--frames", "5"}}) {
      std::vector<std::string> arguments{"run", "small.json", "--quiet", "--out", out};
      arguments.insert(arguments.end(), way.begin(), way.end());
      const Ended ended = run_erg(folder, arguments);
      EXPECT_EQ(ended.exit_code, 2);
      EXPECT_NE(ended.errors.find(std::string(out)), std::string::npos) << ended.errors;
    }
  }
}

#if !defined(ERG_SANITIZE_ADDRESS) && !defined(ERG_SANITIZE_THREAD)  // these take memory of their own

constexpr rlim_t short_memory = rlim_t{700} << 20;

TEST(ShortMemory, AHugeGridSaysWhatItNeedsAndTheGridThatWouldFitFits) {
  const ScratchFolder folder;
  folder.write("small.json", small_config(1));
  const std::vector<std::string> run{"run", "small.json", "--quiet", "--threads", "2"};
  const auto with = [&](const std::string& nx, const std::string& ny) {
    std::vector<std::string> arguments = run;
    arguments.insert(arguments.end(), {"--set", "nx=" + nx, "--set", "ny=" + ny});
    return run_erg(folder, arguments, [] {
      const rlimit limit{short_memory, short_memory};
      setrlimit(RLIMIT_AS, &limit);
    });
  };
  const Ended ended = with("16384", "16384");
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_TRUE(ended.errors.starts_with("grid: 16384 x 16384 cells need ")) << ended.errors;
  const std::string before = "a grid of ";
  const std::size_t at = ended.errors.find(before);
  ASSERT_NE(at, std::string::npos) << ended.errors;
  std::istringstream words(ended.errors.substr(at + before.size()));
  std::string nx, by, ny;
  words >> nx >> by >> ny;
  EXPECT_GE(std::stoi(nx), 2048) << ended.errors;
  const Ended smaller = with(nx, ny);
  EXPECT_EQ(smaller.exit_code, 0) << nx << " x " << ny << ": " << smaller.errors;
}

TEST(ShortMemory, TooManyThreadsAreRefusedInWords) {
  const ScratchFolder folder;
  folder.write("small.json", small_config(1));
  const Ended ended = run_erg(folder, {"run", "small.json", "--quiet", "--threads", "256"}, [] {
    const rlimit limit{short_memory, short_memory};
    setrlimit(RLIMIT_AS, &limit);
  });
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_TRUE(ended.errors.starts_with("threads: the system gives this program ")) << ended.errors;
}

/// Bytes a cell that a run really takes, from two sizes of grid; both hold more than the program does before it runs.
double taken_a_cell(const ScratchFolder& folder, const Config& config) {
  constexpr std::int64_t small = 1200, large = 1800;
  const auto most = [&](std::int64_t side) {
    Config sized = config;
    sized.grid.set("nx", side);
    sized.grid.set("ny", side);
    folder.write("sized.json", io::config_text(sized));
    const Ended ended = run_erg(folder, {"run", "sized.json", "--quiet"});
    EXPECT_EQ(ended.exit_code, 0) << ended.errors;
    return static_cast<double>(ended.most_memory);
  };
  return (most(large) - most(small)) / (large * large - small * small);
}

TEST(ShortMemory, WhatIsSaidOfARunsNeedIsSo) {
  const ScratchFolder folder;
  for (const models::ModelType& type : models::catalogue()) {
    SCOPED_TRACE(type.info.key);
    Config config(type.info.key);
    config.run.set("executor", std::string("cpu"));
    config.run.set("threads", std::int64_t{2});
    config.run.set("steps", std::int64_t{1});
    sim::set_from_text(config, "wind.bearing=240");  // along the grid some models take less
    const double cells = static_cast<double>(config.grid.integer("nx") * config.grid.integer("ny"));
    const double said = static_cast<double>(sim::memory_of_run(config)) / cells;
    const double taken = taken_a_cell(folder, config);
    EXPECT_GT(said, taken);
    EXPECT_LT(said, 1.35 * taken);
  }
}

#endif

}  // namespace
}  // namespace erg::test
