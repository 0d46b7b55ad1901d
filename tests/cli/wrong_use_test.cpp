// Wrong use and bad input: exit code 2, a message that helps, and nothing written.
#include <gtest/gtest.h>

#include <cstdlib>

#include "program.h"

namespace erg::test {
namespace {

void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "expected \"" << part << "\" in:\n" << text;
}

TEST(WrongUse, UnknownCommandUnknownOption) {
  const ScratchFolder folder;
  EXPECT_EQ(run_erg(folder, {"rum"}).exit_code, 2);
  EXPECT_EQ(run_erg(folder, {"run"}).exit_code, 2);
  EXPECT_EQ(run_erg(folder, {"run", "x.json", "--fast"}).exit_code, 2);
  EXPECT_EQ(run_erg(folder, {"run", "x.json", "--format", "gif"}).exit_code, 2);
  EXPECT_EQ(run_erg(folder, {"--version"}).exit_code, 0);
  EXPECT_EQ(run_erg(folder, {"--help"}).exit_code, 0);
}

TEST(WrongUse, WithoutADisplayTheWindowSaysSoAndWhatToDoInstead) {
  unsetenv("DISPLAY");
  const ScratchFolder folder;
  folder.write("small.json", small_config(5));
  const std::vector<std::vector<std::string>> ways{{}, {"gui"}, {"gui", "small.json"}};
  for (const std::vector<std::string>& arguments : ways) {
    const Ended ended = run_erg(folder, arguments);
    EXPECT_EQ(ended.exit_code, 1);
    expect_contains(ended.errors, "DISPLAY: is not set");
    expect_contains(ended.errors, "`erg run` grows dunes");
  }
  EXPECT_EQ(run_erg(folder, {"gui", "gone.json"}).exit_code, 2);
}

TEST(WrongUse, EveryMistakeOfAConfigIsToldAtOnceAndNothingIsWritten) {
  const ScratchFolder folder;
  folder.write("bad.json",
               "{\n"
               "  \"erg\": 1,\n"
               "  \"model\": \"momiji\",\n"
               "  \"grid\": {\"nx\": 0},\n"
               "  \"parameters\": {\"p_sandd\": 0.5, \"p_bare\": \"much\"}\n"
               "}\n");
  for (const char* command : {"run", "check"}) {
    std::vector<std::string> arguments{command, "bad.json"};
    if (std::string(command) == "run") arguments.insert(arguments.end(), {"--out", "out", "--stats", "stats.json"});
    const Ended ended = run_erg(folder, arguments);
    EXPECT_EQ(ended.exit_code, 2);
    expect_contains(ended.errors, "bad.json:4: ");
    expect_contains(ended.errors, "nx");
    expect_contains(ended.errors, "did you mean \"p_sand\"?");
    expect_contains(ended.errors, "p_bare");
  }
  EXPECT_EQ(folder.entries(), std::vector<std::string>{"bad.json"});
}

TEST(WrongUse, EveryMistakeOfTheOptionsIsToldAtOnce) {
  const ScratchFolder folder;
  folder.write("small.json", small_config(5));
  const Ended ended = run_erg(
      folder, {"run", "small.json", "--steps", "many", "--executor", "cpuu", "--set", "sandd=3", "--out", "out"});
  EXPECT_EQ(ended.exit_code, 2);
  expect_contains(ended.errors, "--steps many");
  expect_contains(ended.errors, "did you mean \"cpu\"?");
  expect_contains(ended.errors, "did you mean \"sand\"?");
  EXPECT_EQ(folder.entries(), std::vector<std::string>{"small.json"});
}

TEST(WrongUse, OptionsThatWouldDoNothingAreRefused) {
  const ScratchFolder folder;
  folder.write("small.json", small_config(5));
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"run", "small.json", "--look", "slope"}, "--frames"},
      {{"run", "small.json", "--size", "64x48"}, "--frames"},
      {{"run", "small.json", "--flux"}, "--format vti"},
      {{"render", "small.json", "--out", "a.png", "--paths", "9"}, "momiji moves no single grains"},
      {{"render", "small.json", "--out", "a.png", "--set", "model=grains", "--steps", "0", "--paths", "9"},
       "--steps 1"},
      {{"bench", "--render", "--json"}, "--json"},
      {{"bench", "--context", "egl"}, "--render"},
      {{"gallery", "small.json", "--out", "."}, "no such preset"}};
  for (const auto& [words, word] : cases) {
    const Ended ended = run_erg(folder, words);
    EXPECT_EQ(ended.exit_code, 2) << words.back();
    expect_contains(ended.errors, word);
  }
  EXPECT_EQ(folder.entries(), std::vector<std::string>{"small.json"});
}

TEST(WrongUse, AMissingConfigNamesTheNearestPreset) {
  const ScratchFolder folder;
  const Ended ended = run_erg(folder, {"run", "barchanss"});
  EXPECT_EQ(ended.exit_code, 2);
  expect_contains(ended.errors, "did you mean \"barchans\"?");
}

TEST(WrongUse, AFolderThatIsMissingOrCannotBeMadeIsToldBeforeTheWork) {
  const ScratchFolder folder;
  folder.write("small.json", small_config(1000000000));
  const std::vector<std::vector<std::string>> ways{{"run", "small.json", "--stats", "nowhere/stats.json"},
                                                   {"render", "small.json", "--out", "nowhere/picture.png"},
                                                   {"validate", "--out", "nowhere/validation.md"},
                                                   {"gallery", "--out", "small.json/nowhere"}};
  for (const std::vector<std::string>& arguments : ways) {
    const Ended ended = run_erg(folder, arguments);
    EXPECT_EQ(ended.exit_code, 2) << arguments.front();
    expect_contains(ended.errors, "nowhere");
  }
}

TEST(WrongUse, DamagedAndForeignCheckpointsAreRefused) {
  const ScratchFolder folder;
  folder.write("small.json", small_config(5));
  ASSERT_EQ(run_erg(folder, {"run", "small.json", "--out", ".", "--format", "checkpoint", "--quiet"}).exit_code, 0);
  const std::string good = read_bytes(folder.file("small-000005.checkpoint"));
  ASSERT_GT(good.size(), 100u);

  std::string damaged = good;
  damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 1);
  const std::vector<std::string> refused{damaged, good.substr(0, good.size() - 1), "not a checkpoint", ""};
  for (const std::string& bytes : refused) {
    folder.write("bad.checkpoint", bytes);
    const Ended ended = run_erg(folder, {"run", "--resume", "bad.checkpoint", "--steps", "9"});
    EXPECT_EQ(ended.exit_code, 2);
    expect_contains(ended.errors, "bad.checkpoint");
  }
  EXPECT_EQ(run_erg(folder, {"run", "--resume", "gone.checkpoint"}).exit_code, 2);
}

TEST(WrongUse, ACheckpointUnderAConfigThatDoesNotFitIsRefused) {
  const ScratchFolder folder;
  folder.write("small.json", small_config(5));
  ASSERT_EQ(run_erg(folder, {"run", "small.json", "--out", ".", "--format", "checkpoint", "--quiet"}).exit_code, 0);
  const std::vector<std::string> resume{"run", "small.json", "--resume", "small-000005.checkpoint", "--steps", "9"};
  std::vector<std::string> wider = resume;
  wider.insert(wider.end(), {"--set", "nx=50"});
  const Ended ended = run_erg(folder, wider);
  EXPECT_EQ(ended.exit_code, 2);
  expect_contains(ended.errors, "grid.nx is 48 in the checkpoint and 50 in the config");

  const Ended too_far = run_erg(folder, {"run", "--resume", "small-000005.checkpoint", "--steps", "3"});
  EXPECT_EQ(too_far.exit_code, 2);
  expect_contains(too_far.errors, "step 5");
}

}  // namespace
}  // namespace erg::test
