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

namespace erg::test {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr int usual_deeds = 200;

/// How long to go on: so many deeds, or the seconds asked for.
class Patience {
 public:
  bool is_left(int deeds) const {
    return asked_ == nullptr ? deeds < usual_deeds : spent_ < std::chrono::seconds(std::atoi(asked_));
  }
  /// Time spent at a window that is there.
  void spend(Clock::duration time) { spent_ += time; }

 private:
  const char* const asked_ = std::getenv("ERG_MONKEY_SECONDS");
  Clock::duration spent_{};
};

TEST(Monkey, AtTheWindowBreaksNothing) {
  const TemporaryFolder folder;
  const Display display;
  const std::string terrain = write_small_terrain(folder.path());
  Patience patience;
  int deeds = 0;
  double most_memory = 0;
  for (unsigned seed = 1; patience.is_left(deeds); ++seed) {  // one that finds the way out is followed by another
    DesktopHand hand(display, folder.path(), {terrain, "--width", "1000", "--height", "760"});
    hand.wait_for("RUN/step", true);
    Monkey monkey(seed, 1000, 760);
    while (patience.is_left(deeds) && hand.runs()) {
      const Clock::time_point begin = Clock::now();
      hand.carry_out(monkey.next(hand.spots()));
      std::this_thread::sleep_for(25ms);
      patience.spend(Clock::now() - begin);
      most_memory = std::max(most_memory, hand.memory());
      if (++deeds % 1000 == 0) std::printf("%d deeds, %.0f MiB\n", deeds, hand.memory());
    }
    hand.quit();
    EXPECT_EQ(hand.wait(), 0) << "seed " << seed << ", " << deeds << " deeds\n" << hand.errors();
    EXPECT_EQ(hand.errors(), "");
    if (HasFailure()) return;
  }
  std::printf("%d deeds, at most %.0f MiB\n", deeds, most_memory);
}

}  // namespace
}  // namespace erg::test
