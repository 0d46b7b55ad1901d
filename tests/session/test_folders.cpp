// The file browser's folders, and what is remembered between two days.
#include <gtest/gtest.h>

#include "../unit/mutated.h"
#include "../unit/temporary_folder.h"
#include "core/errors.h"
#include "session/folder_listing.h"
#include "session/settings.h"

namespace erg {

using session::FolderListing;
using session::list_folder;
using session::read_settings;
using session::save_question;
using session::SaveQuestion;
using session::Settings;
using session::settings_folder;
using session::typed_path;
using session::with_ending;
using session::write_settings;

namespace {

namespace fs = std::filesystem;

std::vector<std::string> names(const FolderListing& listing) {
  std::vector<std::string> found;
  for (const session::FolderEntry& entry : listing.entries) found.push_back(entry.name);
  return found;
}

struct FolderTest : testing::Test {
  TemporaryFolder folder;
  FolderTest() {
    fs::create_directory(folder / "zoo");
    fs::create_directory(folder / "Alpha");
    for (const std::string name : {"dune10.json", "dune2.json", "Dune1.JSON", "notes.txt", ".hidden.json"}) {
      write_bytes(folder / name, "x");
    }
  }
};

TEST_F(FolderTest, ListsFoldersFirstAndNamesAsPeopleSort) {
  const FolderListing listing = list_folder(folder.path());
  EXPECT_EQ(listing.problem, "");
  EXPECT_EQ(names(listing),
            (std::vector<std::string>{"Alpha", "zoo", "Dune1.JSON", "dune2.json", "dune10.json", "notes.txt"}));
  EXPECT_TRUE(listing.entries[0].folder);
  EXPECT_EQ(listing.entries[2].bytes, 1u);
  EXPECT_EQ(listing.entries[2].changed.size(), 16u);
}

TEST_F(FolderTest, ShowsOnlyTheEndingsAndTheFilterAskedFor) {
  EXPECT_EQ(names(list_folder(folder.path(), {".json"}, "1")),
            (std::vector<std::string>{"Alpha", "zoo", "Dune1.JSON", "dune10.json"}));
  EXPECT_EQ(names(list_folder(folder.path(), {".json"}, ".hid")),
            (std::vector<std::string>{"Alpha", "zoo", ".hidden.json"}));
}

TEST_F(FolderTest, SaysWhyAFolderCannotBeRead) {
  const FolderListing listing = list_folder(folder / "nowhere");
  EXPECT_NE(listing.problem, "");
  EXPECT_TRUE(listing.entries.empty());
  EXPECT_EQ(list_folder(folder / "zoo" / ".." / "Alpha" / "").folder, folder / "Alpha");
}

TEST_F(FolderTest, UnderstandsTypedPaths) {
  EXPECT_EQ(typed_path("dune.json", "/a/b"), fs::path("/a/b/dune.json"));
  EXPECT_EQ(typed_path(" ../c ", "/a/b"), fs::path("/a/c"));
  EXPECT_EQ(typed_path("/tmp/x", "/a/b"), fs::path("/tmp/x"));
  EXPECT_EQ(typed_path("", "/a/b"), fs::path("/a/b"));
  ::setenv("HOME", "/home/someone", 1);
  EXPECT_EQ(typed_path("~/x", "/a/b"), fs::path("/home/someone/x"));
  EXPECT_EQ(with_ending("/a/dune", ".json"), fs::path("/a/dune.json"));
  EXPECT_EQ(with_ending("/a/dune.JSON", ".json"), fs::path("/a/dune.JSON"));
}

TEST_F(FolderTest, AsksBeforeItOverwrites) {
  EXPECT_EQ(save_question(folder / "new.json"), SaveQuestion::none);
  EXPECT_EQ(save_question(folder / "dune2.json"), SaveQuestion::overwrite);
  EXPECT_EQ(save_question(folder / "zoo"), SaveQuestion::is_folder);
  EXPECT_EQ(save_question(folder / "nowhere" / "new.json"), SaveQuestion::no_folder);
  EXPECT_EQ(save_question(""), SaveQuestion::no_name);
}

TEST(Places, AreFoldersThatExist) {
  const TemporaryFolder home;
  fs::create_directory(home / "Documents");
  ::setenv("HOME", home.path().c_str(), 1);
  std::vector<std::string> labels;
  for (const session::Place& place : session::places("/nowhere")) {
    EXPECT_TRUE(fs::is_directory(place.path)) << place.path;
    labels.push_back(place.label);
  }
  EXPECT_EQ(labels, (std::vector<std::string>{"Home", "Documents", "Working folder", "Computer"}));
}

TEST(Settings, SurviveAFile) {
  const TemporaryFolder folder;
  Settings settings;
  settings.dark = false;
  settings.scale = 1.5;
  settings.window_width = 3840;
  settings.layout["left"] = 320.5;
  settings.last_folder = "/tmp";
  settings.autosave_minutes = 0;
  settings.add_recent("/a/first.json");
  settings.add_recent("/a/second.json");
  settings.add_recent("/a/first.json");
  EXPECT_EQ(settings.recent, (std::vector<std::string>{"/a/first.json", "/a/second.json"}));
  write_settings(folder / "made" / "on the way", settings);
  std::string complaint;
  EXPECT_EQ(read_settings(folder / "made" / "on the way", complaint), settings);
  EXPECT_EQ(complaint, "");
  for (int file = 0; file < 40; ++file) settings.add_recent("/a/" + std::to_string(file));
  EXPECT_EQ(settings.recent.size(), Settings::most_recent);
}

TEST(Settings, NeverKeepTheProgramFromStarting) {
  const TemporaryFolder folder;
  std::string complaint;
  EXPECT_EQ(read_settings(folder.path(), complaint), Settings{});
  EXPECT_EQ(complaint, "") << "a first start is no mistake";
  write_bytes(folder / "settings.json", "{\"dark\": fal");
  EXPECT_EQ(read_settings(folder.path(), complaint), Settings{});
  EXPECT_NE(complaint, "");
  write_bytes(folder / "settings.json",
              R"({"dark": 3, "scale": 900, "window_width": -5, "recent": [1, "/a"], "layout": {"left": "x"}})");
  Settings expected;
  expected.recent = {"/a"};
  EXPECT_EQ(read_settings(folder.path(), complaint), expected);
}

TEST(Settings, MutatedOnesAreReadAsWhatCanBeWritten) {
  const TemporaryFolder folder;
  Settings settings;
  settings.scale = 1.5;
  settings.window_width = 1000;
  settings.layout = {{"left", 300}, {"folded", 1}};
  settings.recent = {"/a/first.json", "/a/d\xfcne.json"};
  write_settings(folder.path(), settings);
  const std::string text = read_bytes(folder / "settings.json");
  test::Mutator mutator(1);
  std::string complaint;
  for (int number = 0; number < test::mutations(200); ++number) {
    write_bytes(folder / "settings.json", mutator.of(text));
    const Settings read = read_settings(folder.path(), complaint);
    write_settings(folder.path(), read);
    EXPECT_EQ(read_settings(folder.path(), complaint), read) << number;
    EXPECT_EQ(complaint, "");
  }
}

TEST(Settings, LieWhereTheEnvironmentSays) {
  ::setenv("HOME", "/home/someone", 1);
  ::unsetenv("XDG_CONFIG_HOME");
  EXPECT_EQ(settings_folder(), fs::path("/home/someone/.config/erg"));
  ::setenv("XDG_CONFIG_HOME", "relative", 1);
  EXPECT_EQ(settings_folder(), fs::path("/home/someone/.config/erg"));
  ::setenv("XDG_CONFIG_HOME", "/etc/xdg", 1);
  ::setenv("XDG_STATE_HOME", "/var/state", 1);
  EXPECT_EQ(settings_folder(), fs::path("/etc/xdg/erg"));
  EXPECT_EQ(session::state_folder(), fs::path("/var/state/erg"));
}

}  // namespace
}  // namespace erg
