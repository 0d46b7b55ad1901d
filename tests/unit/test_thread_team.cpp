// What a thread of the team throws comes to whoever asked for the work; nobody waits for a member that will not come.
#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "transport/executor.h"
#include "transport/thread_team.h"

namespace erg {
namespace {

/// Runs a job of 20 meetings in which `wrong` throws before the meeting `when`; what comes out of it.
std::string thrown_by(ThreadTeam& team, int wrong, int when) {
  std::atomic<int> late{0};
  std::string what;
  try {
    team.run([&](int member) {
      for (int meeting = 0; meeting < 20; ++meeting) {
        if (member == wrong && meeting == when) throw std::runtime_error("member " + std::to_string(member));
        team.meet();
        if (meeting > when) ++late;
      }
    });
  } catch (const std::runtime_error& error) {
    what = error.what();
  }
  if (team.size() > 1) {
    EXPECT_EQ(late, 0) << "nobody goes on from a meeting that did not take place";
  }
  return what;
}

TEST(ThreadTeam, GivesTheCallerWhatAMemberThrows) {
  for (const int size : {1, 2, 3, 8}) {
    ThreadTeam team(size);
    for (int wrong = 0; wrong < size; ++wrong) {
      for (const int when : {0, 1, 7, 19}) {
        EXPECT_EQ(thrown_by(team, wrong, when), "member " + std::to_string(wrong)) << size << " members";
      }
    }
    // It meets as before.
    std::vector<int> seen(static_cast<std::size_t>(size));
    std::atomic<int> arrived{0};
    team.run([&](int member) {
      ++arrived;
      team.meet();
      seen[static_cast<std::size_t>(member)] = arrived;
    });
    for (const int all : seen) EXPECT_EQ(all, size);
  }
}

TEST(ThreadTeam, WhereAllMembersThrowTheCallerGetsOneOfThem) {
  ThreadTeam team(4);
  for (int times = 0; times < 50; ++times) EXPECT_THROW(team.run([](int) { throw std::bad_alloc(); }), std::bad_alloc);
}

TEST(ThreadTeam, APartOfTheTeamThrowsLikeAWhole) {
  ThreadTeam team(5);
  EXPECT_THROW(team.run(3,
                        [&](int member) {
                          if (member == 2) throw std::bad_alloc();
                          team.meet();
                        }),
               std::bad_alloc);
  std::atomic<int> done{0};
  team.run([&](int) {
    team.meet();
    ++done;
  });
  EXPECT_EQ(done, 5);
}

TEST(Executor, ThrowsWhatAPieceOfWorkThrows) {
  for (const char* name : {"serial", "cpu"}) {
    for (const int threads : {1, 2, 3, 8}) {
      const auto executor = make_executor({.name = name, .threads = threads});
      for (const std::int64_t item : {0, 57, 99}) {
        const auto work = [item](std::int64_t begin, std::int64_t end) {
          if (begin <= item && item < end) throw std::bad_alloc();
        };
        EXPECT_THROW(executor->for_pieces(100, work), std::bad_alloc) << name << ", " << threads << " threads";
      }
      std::atomic<std::int64_t> items{0};
      executor->for_pieces(100, [&](std::int64_t begin, std::int64_t end) { items += end - begin; });
      EXPECT_EQ(items, 100) << name << ", " << threads << " threads";
    }
  }
}

}  // namespace
}  // namespace erg
