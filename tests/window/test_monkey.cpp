// Random input on the real window: some seconds in every test run, longer with ERG_MONKEY_SECONDS in the environment.
// The program's memory is watched. What it does lies in a folder that is gone afterwards.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "../ui/monkey.h"
#include "../unit/temporary_folder.h"
#include "desktop_hand.h"
#include "io/config_file.h"

namespace erg::test {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

std::chrono::seconds duration() {
  const char* const asked = std::getenv("ERG_MONKEY_SECONDS");
  return std::chrono::seconds(asked != nullptr ? std::atoi(asked) : 8);
}

std::string small_land(const TemporaryFolder& folder) {
  Config config("momiji");
  config.grid.set("nx", std::int64_t{64});
  config.grid.set("ny", std::int64_t{48});
  config.run.set("threads", std::int64_t{2});
  write_config(folder / "land.json", config);
  return (folder / "land.json").string();
}

TEST(Monkey, AtTheWindowBreaksNothing) {
  const TemporaryFolder folder;
  const Display display;
  const std::string land = small_land(folder);
  const Clock::time_point end = Clock::now() + duration();
  int deeds = 0;
  double most_memory = 0;
  for (unsigned seed = 1; Clock::now() < end; ++seed) {
    DesktopHand hand(display, folder.path(), {land, "--width", "1280", "--height", "800"});
    hand.wait_for("RUN/step");
    Monkey monkey(seed, 1280, 800);
    while (Clock::now() < end && hand.runs()) {
      hand.carry_out(monkey.next(hand.spots()));
      std::this_thread::sleep_for(25ms);
      ++deeds;
      most_memory = std::max(most_memory, hand.memory());
      if (deeds % 1000 == 0) std::printf("%d deeds, %.0f MiB\n", deeds, hand.memory());
    }
    hand.quit();
    EXPECT_EQ(hand.wait(), 0) << "seed " << seed << ", " << deeds << " deeds\n" << hand.errors();
    EXPECT_EQ(hand.errors(), "");
    if (HasFailure()) return;
  }
  std::printf("%d deeds, at most %.0f MiB\n", deeds, most_memory);
  EXPECT_GT(deeds, 20);
}

}  // namespace
}  // namespace erg::test
