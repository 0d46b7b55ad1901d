#include "io/atomic_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "core/errors.h"

namespace erg {
namespace {

namespace fs = std::filesystem;

/// A folder of the test's own, gone at its end.
class AtomicFile : public ::testing::Test {
 protected:
  AtomicFile() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::temp_directory_path() / (std::string("erg_atomic_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    std::ofstream(folder_ / "old.txt") << "old";
  }
  ~AtomicFile() override { fs::remove_all(folder_); }

  static std::string content(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }
  auto files() const { return std::distance(fs::directory_iterator(folder_), {}); }

  fs::path folder_;
};

TEST_F(AtomicFile, WritesNewFilesAndReplacesOldOnes) {
  write_file_atomically(folder_ / "new.txt", "one");
  EXPECT_EQ(content(folder_ / "new.txt"), "one");
  const std::string large(3'000'000, 'x');
  write_file_atomically(folder_ / "old.txt", large);
  EXPECT_EQ(content(folder_ / "old.txt"), large);
  write_file_atomically(folder_ / "old.txt", "");
  EXPECT_EQ(content(folder_ / "old.txt"), "");
  EXPECT_EQ(files(), 2) << "a temporary file was left";
}

TEST_F(AtomicFile, SaysWhyItCannot) {
  const fs::path nowhere = folder_ / "none" / "a.txt";
  try {
    write_file_atomically(nowhere, "x");
    ADD_FAILURE() << "wrote into a folder that does not exist";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), nowhere.string() +
                                ": cannot write this file (No such file or directory); check that its folder exists, "
                                "may be written and has room");
  }
  EXPECT_THROW(write_file_atomically(folder_, "x"), InputError);
  EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFile, AnUnfinishedFileOfAKilledWriterIsNoObstacle) {
  write_file_atomically(folder_ / "old.txt", "one");
  for (int attempt = 0; attempt < 3; ++attempt) {
    std::ofstream(folder_ / ("old.txt.part" + std::to_string(::getpid()) + "-" + std::to_string(attempt))) << "half";
  }
  write_file_atomically(folder_ / "old.txt", "two");
  EXPECT_EQ(content(folder_ / "old.txt"), "two");
}

TEST_F(AtomicFile, KeepsPermissions) {
  const fs::perms own = fs::perms::owner_read | fs::perms::owner_write;
  fs::permissions(folder_ / "old.txt", own);
  write_file_atomically(folder_ / "old.txt", "new");
  EXPECT_EQ(fs::status(folder_ / "old.txt").permissions(), own);
}

TEST_F(AtomicFile, WritesThroughLinks) {
  fs::create_symlink(folder_ / "old.txt", folder_ / "link.txt");
  write_file_atomically(folder_ / "link.txt", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.txt"));
  EXPECT_EQ(content(folder_ / "old.txt"), "new");
}

TEST_F(AtomicFile, DevicesAreWrittenToAndNotReplaced) {
  fs::create_symlink("/dev/null", folder_ / "null");
  write_file_atomically(folder_ / "null", "gone");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "null"));
}

}  // namespace
}  // namespace erg
