// Configs and pictures as people give them on the command line: through pipes, with comments, under names a little off,
// with heights of their own; what is worth telling is told.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <thread>

#include "../unit/png_bytes.h"
#include "io/formats/png_reader.h"
#include "program.h"

namespace erg::test {
namespace {

namespace fs = std::filesystem;

void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "expected \"" << part << "\" in:\n" << text;
}

/// Puts a text before the program as what it reads from this descriptor.
std::function<void()> piped(const std::string& text, int descriptor) {
  return [text, descriptor] {
    int ends[2];
    if (::pipe(ends) != 0 || ::write(ends[1], text.data(), text.size()) != static_cast<ssize_t>(text.size()))
      _exit(125);
    ::close(ends[1]);
    ::dup2(ends[0], descriptor);
  };
}

TEST(GivenFiles, AConfigComesThroughAPipe) {
  const ScratchFolder folder;
  const std::string config = small_config(3);
  const std::string hash = run_erg(folder, {"run", folder.write("a.json", config), "--hash", "--quiet"}).output;
  ASSERT_FALSE(hash.empty());
  EXPECT_EQ(run_erg(folder, {"run", "-", "--hash", "--quiet"}, piped(config, 0)).output, hash);
  EXPECT_EQ(run_erg(folder, {"run", "/dev/stdin", "--hash", "--quiet"}, piped(config, 0)).output, hash);
  EXPECT_EQ(run_erg(folder, {"run", "/dev/fd/57", "--hash", "--quiet"}, piped(config, 57)).output, hash);
  const std::string fifo = folder.file("fifo");
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  std::thread writer([&] { write_bytes(fifo, config); });
  EXPECT_EQ(run_erg(folder, {"run", "fifo", "--hash", "--quiet"}).output, hash);
  writer.join();
}

TEST(GivenFiles, WhatComesThroughAPipeHasItsPicturesInTheWorkingFolderAndItsFilesAName) {
  const ScratchFolder folder;
  folder.write("p.png", PngBytes{.width = 2, .samples = {0, 65535}}.made());
  const std::string config = R"({"erg": 1, "model": "werner", "grid": {"nx": 8, "ny": 4},
      "scene": {"kind": "image", "image": "p.png"}, "run": {"steps": 0}})";
  const Ended ended = run_erg(folder, {"run", "-", "--format", "checkpoint", "--out", "out"}, piped(config, 0));
  EXPECT_EQ(ended.exit_code, 0) << ended.errors;
  EXPECT_TRUE(fs::exists(folder.file("out/config-000000.checkpoint")));
  const Ended broken = run_erg(folder, {"check", "-"}, piped("{\"erg\": 1,\n\"modell\": \"werner\"}", 0));
  EXPECT_EQ(broken.exit_code, 2);
  expect_contains(broken.errors, "standard input:2: unknown key \"modell\"; did you mean \"model\"?");
}

TEST(GivenFiles, CommentsAreToldUnlessNothingIsToBeSaid) {
  const ScratchFolder folder;
  folder.write("a.json", "// mine\n" + small_config(1));
  const std::string note = "note: a.json: its comments are not kept in what is written";
  expect_contains(run_erg(folder, {"check", "a.json"}).output, note);
  expect_contains(run_erg(folder, {"run", "a.json"}).errors, note);
  EXPECT_EQ(run_erg(folder, {"run", "a.json", "--quiet"}).errors, "");
}

TEST(GivenFiles, ANameALittleOffIsMet) {
  const ScratchFolder folder;
  fs::create_directory(folder.file("Mine"));
  folder.write("Mine/Dunes.json", small_config(1));
  const auto told = [&](const std::string& name) { return run_erg(folder, {"check", name}); };
  for (const char* name : {"mine/dunes.json", "Mine\\Dunes.json", "/Mine/Dunes.json", "Mine/Dunes.JSON"}) {
    EXPECT_EQ(told(name).exit_code, 2) << name;
    expect_contains(told(name).errors, "did you mean \"Mine/Dunes.json\"?");
  }
  for (const char* name : {"Barchans", "barchans.json", "cfg/barchans.json", "BARCHAN"}) {
    expect_contains(told(name).errors, "did you mean \"barchans\"?");
  }
  expect_contains(told("thesis\\werner_barchan").errors, "did you mean \"thesis/");
  expect_contains(told("Mine").errors, "Mine: this is a folder; give the name of a config file");
  fs::create_symlink("loop.json", folder.file("loop.json"));
  expect_contains(told("loop.json").errors, "a link that leads back to itself");
  // A folder that is called as a preset is: results of a run, most likely.
  fs::create_directory(folder.file("barchans"));
  EXPECT_EQ(told("barchans").exit_code, 0);
}

TEST(GivenFiles, AWordOfAnotherCaseIsMetByTheRightOne) {
  const ScratchFolder folder;
  folder.write("a.json", small_config(1));
  const std::vector<std::pair<std::vector<std::string>, std::string>> words{
      {{"run", "a.json", "--format", "PNG16"}, "png16"},
      {{"run", "a.json", "--format", "checkpoints"}, "checkpoint"},
      {{"run", "a.json", "--executor", "CPU"}, "cpu"},
      {{"run", "a.json", "--set", "model=Werner"}, "werner"},
      {{"run", "a.json", "--set", "scene.kind=RIPPLES"}, "ripples"},
      {{"run", "a.json", "--set", "CELL_SIZE=2"}, "cell_size"},
      {{"render", "a.json", "--out", "a.png", "--camera", "Top"}, "top"},
      {{"model", "Bishop"}, "bishop"}};
  for (const auto& [arguments, word] : words) {
    const Ended ended = run_erg(folder, arguments);
    EXPECT_EQ(ended.exit_code, 2) << word;
    expect_contains(ended.errors, "did you mean \"" + word + "\"?");
  }
}

std::string metre_entry(const fs::path& png, const std::string& key) {
  for (const auto& [name, text] : io::read_png_metadata(png)) {
    if (name == key) return text;
  }
  return "none";
}

TEST(GivenFiles, AHeightmapThatErgWroteIsTheSameGroundAgain) {
  const ScratchFolder folder;
  folder.write("a.json", R"({"erg": 1, "model": "momiji", "grid": {"nx": 32, "ny": 24},
      "scene": {"kind": "transverse", "sand": 20}, "run": {"steps": 20}})");
  ASSERT_EQ(run_erg(folder, {"run", "a.json", "--format", "png16", "--out", "a", "--quiet"}).exit_code, 0);
  const std::string first = folder.file("a/a-000020-height.png");
  folder.write("b.json", R"({"erg": 1, "model": "momiji", "scene": {"kind": "image", "image": "a/a-000020-height.png",
      "image_role": "sand", "image_fit": "from_file"}, "run": {"steps": 0}})");
  const Ended check = run_erg(folder, {"check", "b.json"});
  expect_contains(check.output, "32 x 24 cells");
  expect_contains(check.output, "note: a/a-000020-height.png: heights in the picture, ");
  const Ended again = run_erg(folder, {"run", "b.json", "--format", "png16", "--out", "b"});
  ASSERT_EQ(again.exit_code, 0) << again.errors;
  expect_contains(again.errors, "heights in the picture, ");
  const std::string second = folder.file("b/b-000000-height.png");
  for (const char* key : {"erg:low_m", "erg:high_m", "erg:cell_m"}) {
    EXPECT_EQ(metre_entry(second, key), metre_entry(first, key)) << key;
  }
  const auto pixels = [](const std::string& path) {
    std::vector<std::uint16_t> all;
    io::PngReader(path).read_rows(
        [&](int, std::span<const std::uint16_t> row) { all.insert(all.end(), row.begin(), row.end()); });
    return all;
  };
  EXPECT_EQ(pixels(second), pixels(first));
}

#if !defined(ERG_SANITIZE_ADDRESS) && !defined(ERG_SANITIZE_THREAD)  // their own memory would be counted

TEST(GivenFiles, WantOfMemoryIsNotToldAsADamagedPicture) {
  const ScratchFolder folder;
  const auto told = [&](const PngBytes& png, int nx, int ny) {
    folder.write("p.png", png.made());
    folder.write("c.json", R"({"erg": 1, "model": "werner", "grid": {"nx": )" + std::to_string(nx) + R"(, "ny": )" +
                               std::to_string(ny) +
                               R"(}, "scene": {"kind": "image", "image": "p.png"}, "run": {"steps": 0}})");
    return run_erg(folder, {"check", "c.json"}, [] {
      const rlimit limit{rlim_t{300} << 20, rlim_t{300} << 20};
      setrlimit(RLIMIT_AS, &limit);
    });
  };
  const PngBytes sound{.width = 64, .height = 64, .bits = 1, .samples = std::vector<int>(64 * 64)};
  EXPECT_EQ(told(sound, 256, 256).exit_code, 0);
  const Ended large_grid = told(sound, 16384, 8192);
  EXPECT_NE(large_grid.exit_code, 0);
  expect_contains(large_grid.errors, "memory");
  EXPECT_EQ(large_grid.errors.find("damaged"), std::string::npos) << large_grid.errors;
  // Interlaced, all of it has to be held, 600 MB: that is known before its pixels are read.
  PngBytes large = sound;
  large.interlaced = true;
  std::string bytes = large.made();
  bytes.replace(16, 8, big_endian(60000) + big_endian(5000));
  folder.write("large.png", with_right_checksums(bytes));
  folder.write("d.json", R"({"erg": 1, "model": "werner", "scene": {"kind": "image", "image": "large.png"}})");
  const Ended interlaced = run_erg(folder, {"check", "d.json"}, [] {
    const rlimit limit{rlim_t{300} << 20, rlim_t{300} << 20};
    setrlimit(RLIMIT_AS, &limit);
  });
  EXPECT_EQ(interlaced.exit_code, 2);
  expect_contains(interlaced.errors, "is interlaced and has to be held whole: that needs 572 MiB of memory");
}

#endif

/// What no executor counts: more than 40000 slabs.
TEST(GivenFiles, LandThatIsTooHighForAModelIsRefusedBeforeItIsRun) {
  const ScratchFolder folder;
  folder.write("p.png", PngBytes{.width = 2, .samples = {0, 65535}}.made());
  const std::string picture = R"("kind": "image", "image": "p.png", "image_high": )";
  const std::vector<std::pair<std::string, std::string>> all{
      {"werner", picture + "4010"},
      {"momiji", R"("kind": "rocks", "height": 4010)"},
      {"bishop", R"("kind": "cone", "height": 6000, "radius": 4)"},
      {"nield_baas", picture + R"(4010, "image_role": "sand")"},
      {"snow_packing", R"("kind": "valley", "height": 4600)"},
      {"snow_sintering", picture + "4010"},
      {"snow_sintering", picture + R"(4010, "image_role": "sand")"}};
  const std::string thin = R"("parameters": {"slab_height": 0.1}, )";
  for (const auto& [model, scene] : all) {
    SCOPED_TRACE(model + ": " + scene);
    folder.write("high.json", R"({"erg": 1, "model": ")" + model + R"(", "grid": {"nx": 16, "ny": 12}, )" + thin +
                                  R"("scene": {)" + scene + R"(}, "run": {"steps": 1}})");
    const Ended checked = run_erg(folder, {"check", "high.json"});
    EXPECT_EQ(checked.exit_code, 2);
    EXPECT_TRUE(checked.errors.starts_with("terrain: it ")) << checked.errors;
    expect_contains(checked.errors, "more than 40000");
    const Ended run = run_erg(folder, {"run", "high.json", "--quiet", "--out", "o", "--format", "csv"});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_EQ(run.errors, checked.errors);
    EXPECT_FALSE(fs::exists(folder.file("o"))) << "nothing is begun";
  }
  // A little lower.
  folder.write("low.json", R"({"erg": 1, "model": "werner", "grid": {"nx": 16, "ny": 12}, )" + thin + R"("scene": {)" +
                               picture + R"(3990}, "run": {"steps": 1}})");
  EXPECT_EQ(run_erg(folder, {"check", "low.json"}).exit_code, 0);
  EXPECT_EQ(run_erg(folder, {"run", "low.json", "--quiet"}).exit_code, 0);
}

}  // namespace
}  // namespace erg::test
