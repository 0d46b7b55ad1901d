// What a thread of the pool throws comes to whoever asked for the work; nobody waits for a member that will not come.
#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "compute/executor.h"
#include "compute/thread_pool.h"
#include "sim/make_executor.h"

namespace erg {

using compute::ThreadPool;

namespace {

/// Runs a job of 20 meetings in which `wrong` throws before the meeting `when`; what comes out of it.
std::string thrown_by(ThreadPool& pool, int wrong, int when) {
  std::atomic<int> late{0};
  std::string what;
  try {
    pool.run([&](int member) {
      for (int meeting = 0; meeting < 20; ++meeting) {
        if (member == wrong && meeting == when) throw std::runtime_error("member " + std::to_string(member));
        pool.barrier();
        if (meeting > when) ++late;
      }
    });
  } catch (const std::runtime_error& error) {
    what = error.what();
  }
  if (pool.size() > 1) {
    EXPECT_EQ(late, 0) << "nobody goes on from a meeting that did not take place";
  }
  return what;
}

TEST(ThreadPool, GivesTheCallerWhatAMemberThrows) {
  for (const int size : {1, 2, 3, 8}) {
    ThreadPool pool(size);
    for (int wrong = 0; wrong < size; ++wrong) {
      for (const int when : {0, 1, 7, 19}) {
        EXPECT_EQ(thrown_by(pool, wrong, when), "member " + std::to_string(wrong)) << size << " members";
      }
    }
    // It meets as before.
    std::vector<int> seen(static_cast<std::size_t>(size));
    std::atomic<int> arrived{0};
    pool.run([&](int member) {
      ++arrived;
      pool.barrier();
      seen[static_cast<std::size_t>(member)] = arrived;
    });
    for (const int all : seen) EXPECT_EQ(all, size);
  }
}

TEST(ThreadPool, WhereAllMembersThrowTheCallerGetsOneOfThem) {
  ThreadPool pool(4);
  for (int times = 0; times < 50; ++times) EXPECT_THROW(pool.run([](int) { throw std::bad_alloc(); }), std::bad_alloc);
}

TEST(ThreadPool, APartOfTheTeamThrowsLikeAWhole) {
  ThreadPool pool(5);
  EXPECT_THROW(pool.run(3,
                        [&](int member) {
                          if (member == 2) throw std::bad_alloc();
                          pool.barrier();
                        }),
               std::bad_alloc);
  std::atomic<int> done{0};
  pool.run([&](int) {
    pool.barrier();
    ++done;
  });
  EXPECT_EQ(done, 5);
}

TEST(Executor, ThrowsWhatAPieceOfWorkThrows) {
  for (const char* name : {"serial", "cpu"}) {
    for (const int threads : {1, 2, 3, 8}) {
      const auto executor = sim::make_executor({.name = name, .threads = threads});
      for (const std::int64_t item : {0, 57, 99}) {
        const auto work = [item](std::int64_t begin, std::int64_t end) {
          if (begin <= item && item < end) throw std::bad_alloc();
        };
        EXPECT_THROW(executor->parallel_for(100, work), std::bad_alloc) << name << ", " << threads << " threads";
      }
      std::atomic<std::int64_t> items{0};
      executor->parallel_for(100, [&](std::int64_t begin, std::int64_t end) { items += end - begin; });
      EXPECT_EQ(items, 100) << name << ", " << threads << " threads";
    }
  }
}

}  // namespace
}  // namespace erg
