#include "io/files/atomic_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "core/errors.h"
#include "temporary_folder.h"

namespace erg {

using io::unfinished_name;
using io::write_file_atomically;

namespace {

namespace fs = std::filesystem;

class AtomicFile : public ::testing::Test {
 protected:
  AtomicFile() { write_bytes(folder_ / "old.txt", "old"); }

  auto files() const { return std::distance(fs::directory_iterator(folder_.path()), {}); }

  TemporaryFolder folder_;
};

TEST_F(AtomicFile, WritesNewFilesAndReplacesOldOnes) {
  write_file_atomically(folder_ / "new.txt", "one");
  EXPECT_EQ(read_bytes(folder_ / "new.txt"), "one");
  const std::string large(3'000'000, 'x');
  write_file_atomically(folder_ / "old.txt", large);
  EXPECT_EQ(read_bytes(folder_ / "old.txt"), large);
  write_file_atomically(folder_ / "old.txt", "");
  EXPECT_EQ(read_bytes(folder_ / "old.txt"), "");
  EXPECT_EQ(files(), 2) << "a temporary file was left";
}

TEST_F(AtomicFile, SaysWhyItCannot) {
  const fs::path nowhere = folder_.path() / "none" / "a.txt";
  try {
    write_file_atomically(nowhere, "x");
    ADD_FAILURE() << "wrote into a folder that does not exist";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), nowhere.string() +
                                ": cannot write this file (No such file or directory); check that its folder exists, "
                                "may be written and has room");
  }
  EXPECT_THROW(write_file_atomically(folder_.path(), "x"), InputError);
  EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFile, AnUnfinishedFileOfAKilledWriterIsWrittenOver) {
  write_bytes(unfinished_name(folder_ / "old.txt"), std::string(100, 'x'));
  write_file_atomically(folder_ / "old.txt", "two");
  EXPECT_EQ(read_bytes(folder_ / "old.txt"), "two");
  EXPECT_EQ(files(), 1) << "nothing is left of it";
}

TEST_F(AtomicFile, AnUnfinishedFileThatCannotBeEmptiedIsClosedAgain) {
  const auto open_files = [] { return std::distance(fs::directory_iterator("/proc/self/fd"), {}); };
  // A pipe with a reader can be opened for writing, but it has no length.
  const std::string pipe = unfinished_name(folder_ / "old.txt");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  const auto before = open_files();
  EXPECT_THROW(write_file_atomically(folder_ / "old.txt", "new"), io::WriteError);
  EXPECT_EQ(open_files(), before);
  EXPECT_EQ(read_bytes(folder_ / "old.txt"), "old");
  ::close(reader);
}

TEST_F(AtomicFile, WritersOfOneFileDoNotMeet) {
  const fs::path path = folder_ / "old.txt";
  write_file_atomically(path, [&](const io::ByteSink& outer) {
    outer("outer, ");
    write_file_atomically(path, "inner");
    EXPECT_EQ(read_bytes(path), "inner");
    outer("whole");
  });
  EXPECT_EQ(read_bytes(path), "outer, whole");
  EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFile, ManyThreadsLeaveOneWholeFile) {
  const fs::path path = folder_ / "old.txt";
  std::vector<std::thread> writers;
  for (char letter = 'a'; letter < 'e'; ++letter) {
    writers.emplace_back([&path, letter] {
      for (int round = 0; round < 20; ++round) write_file_atomically(path, std::string(5000, letter));
    });
  }
  for (std::thread& writer : writers) writer.join();
  const std::string text = read_bytes(path);
  EXPECT_EQ(text, std::string(5000, text.front()));
  EXPECT_EQ(files(), 1);
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
  EXPECT_EQ(read_bytes(folder_ / "old.txt"), "new");
}

TEST_F(AtomicFile, DevicesAreWrittenToAndNotReplaced) {
  fs::create_symlink("/dev/null", folder_ / "null");
  write_file_atomically(folder_ / "null", "gone");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "null"));
}

}  // namespace
}  // namespace erg
