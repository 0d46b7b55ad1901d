// What the machine does to the program: streams that are full or closed, file systems that cannot flush, processors
// that are not all its own, sets of instructions; and words that are nearly right.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

#include "../unit/limits.h"
#include "../unit/png_bytes.h"
#include "program.h"

namespace erg::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const std::vector<Words>& printing_commands() {
  static const std::vector<Words> all{{"schema"},
                                      {"models"},
                                      {"presets"},
                                      {"model", "momiji"},
                                      {"check", "a.json"},
                                      {"run", "a.json"},
                                      {"--help"},
                                      {"--version"},
                                      {"run", "--help"},
                                      {"run", "a.json", "--quiet", "--hash"},
                                      {"render", "a.json", "--out", "a.png", "--size", "48x32"}};
  return all;
}

TEST(StandardOutput, FullOrClosedIsAFailure) {
  const ScratchFolder folder;
  folder.write("a.json", small_config(2));
  for (const Words& words : printing_commands()) {
    SCOPED_TRACE(words.front() + " " + words.back());
    EXPECT_EQ(run_erg(folder, words).exit_code, 0);
    const Ended full = run_erg(folder, words, [] { ::dup2(::open("/dev/full", O_WRONLY), STDOUT_FILENO); });
    EXPECT_EQ(full.exit_code, 1);
    EXPECT_NE(full.errors.find("standard output: cannot be written"), std::string::npos) << full.errors;
    const Ended closed = run_erg(folder, words, [] { ::close(STDOUT_FILENO); });
    EXPECT_EQ(closed.exit_code, 1);
    EXPECT_NE(closed.errors.find("standard output: cannot be written"), std::string::npos) << closed.errors;
    const Ended unread = run_erg(folder, words, [] {  // a pipe that nobody reads
      int ends[2];
      if (::pipe(ends) != 0) _exit(125);
      ::close(ends[0]);
      ::dup2(ends[1], STDOUT_FILENO);
      ::close(ends[1]);
    });
    EXPECT_EQ(unread.exit_code, 1);
  }
}

TEST(StandardOutput, WhatIsNotPrintedDoesNotFail) {
  const ScratchFolder folder;
  folder.write("a.json", small_config(2));
  const auto close_all = [] {
    for (const int stream : {0, 1, 2}) ::close(stream);
  };
  const Ended ended =
      run_erg(folder, {"run", "a.json", "--quiet", "--out", "o", "--format", "checkpoint,csv"}, close_all);
  EXPECT_EQ(ended.exit_code, 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.file("o")), {}), 2);
  // No file has taken the place of a stream: what would be printed is in none of them.
  EXPECT_EQ(run_erg(folder, {"run", "a.json", "--out", "p", "--format", "checkpoint,csv"}, close_all).exit_code, 1);
  EXPECT_EQ(read_bytes(folder.file("p/a-000002.checkpoint")), read_bytes(folder.file("o/a-000002.checkpoint")));
}

/// A library that stands before the system's and lets fsync fail with the error of the variable FSYNC_ERROR.
std::string failing_fsync(const ScratchFolder& folder) {
  folder.write("fsync.c",
               "#include <errno.h>\n#include <stdlib.h>\n"
               "int fsync(int file) { (void)file; errno = atoi(getenv(\"FSYNC_ERROR\")); return -1; }\n");
  const std::string library = folder.file("fsync.so");
  const std::string command = "gcc -shared -fPIC -o '" + library + "' '" + folder.file("fsync.c") + "'";
  return std::system(command.c_str()) == 0 ? library : std::string();
}

TEST(FileSystem, ThatCannotFlushIsWrittenToAndTold) {
#if defined(ERG_SANITIZE_ADDRESS) || defined(ERG_SANITIZE_THREAD)
  GTEST_SKIP() << "a sanitizer wants to be loaded before the library that stands in";
#endif
  const ScratchFolder folder;
  folder.write("a.json", small_config(2));
  const Words run{"run", "a.json", "--quiet", "--out", "o", "--format", "checkpoint,csv"};
  const std::string library = failing_fsync(folder);
  ASSERT_FALSE(library.empty());
  const auto fails_with = [&](int error) {
    return run_erg(folder, run, [&] {
      ::setenv("FSYNC_ERROR", std::to_string(error).c_str(), 1);
      ::setenv("LD_PRELOAD", library.c_str(), 1);
    });
  };
  for (const int error : {EINVAL, ENOTSUP, ENOSYS, EROFS}) {
    SCOPED_TRACE(error);
    const Ended ended = fails_with(error);
    EXPECT_EQ(ended.exit_code, 0) << ended.errors;
    const std::size_t told = ended.errors.find("note: the file system does not let files be flushed");
    ASSERT_NE(told, std::string::npos) << ended.errors;
    EXPECT_EQ(ended.errors.find("note: ", told + 1), std::string::npos) << "once";
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.file("o")), {}), 2);
  }
  // What says that the content is lost is an error.
  const Ended lost = fails_with(EIO);
  EXPECT_EQ(lost.exit_code, 1);
  EXPECT_NE(lost.errors.find("cannot write this file (Input/output error)"), std::string::npos) << lost.errors;
  EXPECT_EQ(run_erg(folder, run).errors, "") << "nothing to tell";
}

TEST(Processors, OnlyThoseThatAreAllowedAreUsed) {
  const ScratchFolder folder;
  folder.write("a.json", small_config(1));
  const Words run{"run", "a.json", "--stats", "s.json", "--quiet", "--executor", "cpu"};
  ASSERT_EQ(run_erg(folder, run).exit_code, 0);
  cpu_set_t all;
  ASSERT_EQ(::sched_getaffinity(0, sizeof all, &all), 0);
  EXPECT_LE(read_json(folder.file("s.json")).at("threads"), CPU_COUNT(&all));
  ASSERT_EQ(run_erg(folder, run,
                    [] {
                      cpu_set_t allowed, one;
                      ::sched_getaffinity(0, sizeof allowed, &allowed);
                      CPU_ZERO(&one);
                      for (int k = 0; CPU_COUNT(&one) == 0; ++k) {
                        if (CPU_ISSET(k, &allowed)) CPU_SET(k, &one);
                      }
                      ::sched_setaffinity(0, sizeof one, &one);
                    })
                .exit_code,
            0);
  EXPECT_EQ(read_json(folder.file("s.json")).at("threads"), 1);
  ASSERT_EQ(run_erg(folder, run, [] { ::setenv("SLURM_CPUS_PER_TASK", "1", 1); }).exit_code, 0);
  EXPECT_EQ(read_json(folder.file("s.json")).at("threads"), 1);
}

TEST(Processors, WhereTheSystemGivesFewerThreadsTheseWillDo) {
  const ScratchFolder folder;
  folder.write("a.json", small_config(1));
  fs::permissions(folder.file("."), fs::perms::all);
  const auto one_thread = [] {
    constexpr uid_t somebody = 61234;  // root has no limit
    if (::getuid() == 0 && ::setuid(somebody) != 0) _exit(125);
    const rlimit limit{1, 1};
    ::setrlimit(RLIMIT_NPROC, &limit);
  };
  const Words run{"run", "a.json", "--stats", "s.json", "--quiet", "--executor", "cpu", "--threads"};
  const auto with = [&](const std::string& threads) {
    Words words = run;
    words.push_back(threads);
    return run_erg(folder, words, one_thread);
  };
  const Ended any = with("0");
  EXPECT_EQ(any.exit_code, 0) << any.errors;
  EXPECT_EQ(read_json(folder.file("s.json")).at("threads"), 1);
  const Ended eight = with("8");
  EXPECT_EQ(eight.exit_code, 2);
  EXPECT_EQ(eight.errors,
            "threads: the system gives this program 1 of 8 threads; "
            "ask for fewer, or for 0, as many as there are (--threads, run.threads)\n");
}

TEST(Memory, OfABatchJobCounts) {
  const ScratchFolder folder;
  folder.write("a.json", small_config(1));
  const Ended ended = run_erg(folder, {"run", "a.json", "--quiet", "--set", "nx=8192", "--set", "ny=8192"},
                              [] { ::setenv("SLURM_MEM_PER_NODE", "300", 1); });
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_TRUE(ended.errors.starts_with("grid: 8192 x 8192 cells need ")) << ended.errors;
}

TEST(Instructions, CanBeForcedAndGiveTheSameBits) {
  const ScratchFolder folder;
  folder.write("a.json", small_config(20));
  const Words run{"run", "a.json", "--executor", "cpu", "--quiet", "--hash", "--stats", "s.json"};
  const std::string best = run_erg(folder, run).output;
  EXPECT_EQ(best.size(), 17u);
  Words portable = run;
  portable.insert(portable.end(), {"--instructions", "portable"});
  EXPECT_EQ(run_erg(folder, portable).output, best);
  EXPECT_EQ(read_json(folder.file("s.json")).at("instructions"), "portable");
  const auto wanted = [&](const std::string& set) {
    return run_erg(folder, run, [set] { ::setenv("ERG_INSTRUCTIONS", set.c_str(), 1); });
  };
  EXPECT_EQ(wanted("portable").output, best);
  EXPECT_EQ(read_json(folder.file("s.json")).at("instructions"), "portable");
  EXPECT_EQ(wanted("").output, best);
  const Ended unknown = wanted("avx");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.errors.find("ERG_INSTRUCTIONS: unknown instructions \"avx\""), std::string::npos) << unknown.errors;
  Words wrong = run;
  wrong.insert(wrong.end(), {"--instructions", "AVX2"});
  const Ended nearly = run_erg(folder, wrong);
  EXPECT_EQ(nearly.exit_code, 2);
  EXPECT_NE(nearly.errors.find("--instructions: unknown instructions \"AVX2\""), std::string::npos) << nearly.errors;
}

// A shadow of such heights would go around these grids hundreds of times.
TEST(Processors, TallRocksAreNoEndlessWork) {
  const ScratchFolder folder;
  folder.write("a.json", small_config(2));
  std::vector<int> spire(128 * 128);
  spire[64 * 128 + 64] = 65535;
  folder.write("spire.png", PngBytes{.width = 128, .height = 128, .samples = spire}.made());
  const Words rocks{"--set", "nx=20", "--set", "ny=20", "--set", "scene.kind=rocks", "--set", "height=10000"};
  const Words one_column{"--set", "nx=128",           "--set", "ny=128",
                         "--set", "scene.kind=image", "--set", "scene.image=spire.png",
                         "--set", "image_high=13000"};
  for (const Words& ground : {rocks, one_column}) {
    for (const char* executor : {"serial", "cpu"}) {
      for (const char* bearing : {"W", "285", "N"}) {
        Words words{"run",     "a.json", "--executor", executor,
                    "--quiet", "--hash", "--set",      std::string("wind.bearing=") + bearing};
        words.insert(words.end(), ground.begin(), ground.end());
        // A safeguard and no measurement: it takes a fraction of that.
        const Ended ended = run_erg(folder, words, [] {
          const rlimit limit{20, 20};
          setrlimit(RLIMIT_CPU, &limit);
        });
        EXPECT_EQ(ended.exit_code, 0) << executor << ", " << bearing << ": " << ended.errors;
      }
    }
  }
}

TEST(Words, ThatAreEmptyAreRefused) {
  const ScratchFolder folder;
  folder.write("a.json", small_config(1));
  const std::vector<Words> all{{"run", "a.json", "--out", ""},
                               {"run", "a.json", "--out="},
                               {"run", "a.json", "--stats", ""},
                               {"run", "a.json", "--resume", ""},
                               {"run", ""},
                               {"run", "a.json", "--format", ""},
                               {"run", "a.json", "--every", ""},
                               {"run", "a.json", "--set", ""},
                               {"run", "a.json", "--seed", ""},
                               {"render", "a.json", "--out", ""},
                               {"check", ""},
                               {"model", ""},
                               {"render", "", "--out", "a.png"},
                               {"gallery", "--out", ""},
                               {"validate", "--out", ""},
                               {"validate", "--section", ""},
                               {"bench", "--model", ""},
                               {"bench", "--bearing", ""},
                               {"run", "a.json", "--executor", ""},
                               {"run", "a.json", "--frames", "1", "--look", ""}};
  for (const Words& words : all) {
    const Ended ended = run_erg(folder, words);
    EXPECT_EQ(ended.exit_code, 2) << words.front() << " " << words[words.size() - 2];
    EXPECT_LT(ended.errors.size(), 500u) << ended.errors;
  }
  EXPECT_EQ(folder.entries(), Words{"a.json"});
}

TEST(Words, OutOfRangeAreRefusedInAShortLine) {
  const ScratchFolder folder;
  folder.write("a.json", small_config(1));
  const std::vector<std::pair<Words, std::string>> all{
      {{"run", "a.json", "--every", "0"}, "expected a whole number, 1 to 1000000000"},
      {{"run", "a.json", "--every", "-1"}, "expected a whole number, 1 to 1000000000"},
      {{"run", "a.json", "--every", "1e10"}, "expected a whole number, 1 to 1000000000"},
      {{"run", "a.json", "--every", "99999999999999999999"}, "expected a whole number, 1 to 1000000000"},
      {{"run", "a.json", "--frames", "0"}, "expected a whole number, 1 to 1000000000"},
      {{"run", "a.json", "--frames", "1.5"}, "expected a whole number, 1 to 1000000000"},
      {{"run", "a.json", "--seed", "9007199254740993"}, "0 to 9007199254740992"},
      {{"run", "a.json", "--seed", "9007199254740993.0"}, "0 to 9007199254740992"},
      {{"run", "a.json", "--set", "seed=9223372036854775807"}, "0 to 9007199254740992"},
      {{"render", "a.json", "--out", "a.png", "--steps", "-1"}, "expected a whole number, 0 to 1000000000"},
      {{"render", "a.json", "--out", "a.png", "--supersample", "1e3"}, "expected a whole number, 1 to 4"},
      {{"render", "a.json", "--out", "a.png", "--contours", "nan"}, "expected a number"},
      {{"bench", "--grid", "1"}, "expected a whole number, 16 to"}};
  for (const auto& [words, said] : all) {
    const Ended ended = run_erg(folder, words);
    EXPECT_EQ(ended.exit_code, 2) << words.back();
    EXPECT_NE(ended.errors.find(said), std::string::npos) << ended.errors;
    EXPECT_LT(ended.errors.size(), 250u) << ended.errors;
  }
  EXPECT_EQ(run_erg(folder, {"run", "a.json", "--seed", "9007199254740992", "--quiet"}).exit_code, 0);
}

TEST(Words, ThatAreNearlyRightGetTheRightOne) {
  const ScratchFolder folder;
  folder.write("a.json", small_config(10));
  ASSERT_EQ(
      run_erg(folder, {"run", "a.json", "--out", "o", "--format", "checkpoint", "--every", "5", "--quiet"}).exit_code,
      0);
  const std::vector<std::pair<Words, std::string>> all{
      {{"rum"}, "did you mean \"run\"?"},
      {{"run", "a.json", "--step", "5"}, "did you mean \"--steps\"?"},
      {{"run", "a.json", "--outt=o"}, "did you mean \"--out\"?"},
      {{"run", "--resume", "o"}, "this is a folder; did you mean \"o/a-000010.checkpoint\"?"},
      {{"run", "o/a-000010.checkpoint"}, "go on from it with --resume"},
      {{"render", "a.json", "--out", "a.gif"}, "did you mean \"a.png\"?"},
      {{"render", "a.json", "--out", "a.jpg", "--transparent"}, "a JPEG has no opacity"}};
  for (const auto& [words, said] : all) {
    const Ended ended = run_erg(folder, words);
    EXPECT_EQ(ended.exit_code, 2) << words.back();
    EXPECT_NE(ended.errors.find(said), std::string::npos) << ended.errors;
  }
}

TEST(Words, AJpegIsAJpeg) {
  const ScratchFolder folder;
  folder.write("a.json", small_config(1));
  for (const char* name : {"a.jpg", "b.JPEG"}) {
    ASSERT_EQ(run_erg(folder, {"render", "a.json", "--out", name, "--size", "48x32", "--quiet"}).exit_code, 0);
    const std::string bytes = read_bytes(folder.file(name));
    EXPECT_TRUE(bytes.starts_with("\xff\xd8\xff")) << "how a JPEG begins";
    EXPECT_NE(bytes.find("erg:seed: 7\n"), std::string::npos) << "it says where it comes from";
  }
  ASSERT_EQ(run_erg(folder, {"render", "a.json", "--out", "c.png", "--size", "48x32", "--quiet"}).exit_code, 0);
  EXPECT_TRUE(read_bytes(folder.file("c.png")).starts_with("\x89PNG"));
}

}  // namespace
}  // namespace erg::test
