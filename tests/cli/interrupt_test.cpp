// Ctrl-C and its kin: the step ends, a checkpoint is written, and the run goes on from it to the same bits.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "program.h"

namespace erg::test {
namespace {

using namespace std::chrono_literals;

// The first checkpoint tells that the run is under way; it has so many steps that it cannot end by itself.
const std::vector<std::string> long_run{"run",     "small.json", "--out",  "out", "--format", "csv,checkpoint",
                                        "--every", "50",         "--quiet"};

void wait_for_the_first_checkpoint(const ScratchFolder& folder) {
  const std::string first_checkpoint = folder.file("out/small-000050.checkpoint");
  for (int i = 0; i < 3000 && !std::filesystem::exists(first_checkpoint); ++i) std::this_thread::sleep_for(10ms);
  ASSERT_TRUE(std::filesystem::exists(first_checkpoint));
}

TEST(Interrupt, LeavesACheckpointThatGoesOnToTheSameBits) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    SCOPED_TRACE(signal);
    const ScratchFolder folder;
    folder.write("small.json", small_config(1000000));
    Program program(folder, long_run, [signal] { std::signal(signal, SIG_DFL); });
    wait_for_the_first_checkpoint(folder);
    program.send(signal);
    if (signal == SIGHUP) program.send(signal);  // a terminal that closes may send it twice
    const Ended ended = program.wait();
    EXPECT_EQ(ended.exit_code, 1);

    // "Interrupted after step N of 1000000. Go on with: erg run --resume PATH --out out"
    const std::string before_step = "Interrupted after step ";
    ASSERT_NE(ended.errors.find(before_step), std::string::npos) << ended.errors;
    const int step = std::stoi(ended.errors.substr(ended.errors.find(before_step) + before_step.size()));
    const std::string before_path = "erg run --resume ";
    const std::size_t path_at = ended.errors.find(before_path) + before_path.size();
    const std::string path = ended.errors.substr(path_at, ended.errors.find(' ', path_at) - path_at);
    ASSERT_TRUE(std::filesystem::exists(folder.path() / path)) << path;

    const std::string last = std::to_string(step + 5);
    const Ended resumed = run_erg(folder, {"run", "--resume", path, "--steps", last, "--hash", "--quiet"});
    ASSERT_EQ(resumed.exit_code, 0) << resumed.errors;
    const Ended whole = run_erg(folder, {"run", "small.json", "--steps", last, "--hash", "--quiet"});
    EXPECT_EQ(resumed.output, whole.output);
  }
}

TEST(Interrupt, WhatTheProgramWasToldToIgnoreItIgnores) {
  const ScratchFolder folder;
  folder.write("small.json", small_config(1000000));
  Program program(folder, long_run, [] {
    std::signal(SIGHUP, SIG_IGN);  // as nohup does
    std::signal(SIGTERM, SIG_DFL);
  });
  wait_for_the_first_checkpoint(folder);
  program.send(SIGHUP);
  std::this_thread::sleep_for(50ms);
  program.send(SIGTERM);
  const Ended ended = program.wait();
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_NE(ended.errors.find("Interrupted after step "), std::string::npos)
      << "the second signal would have killed it";
}

}  // namespace
}  // namespace erg::test
