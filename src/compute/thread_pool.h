// A pool of threads that stays together: it runs one job on all members and lets them meet at a barrier.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <thread>
#include <vector>

#include "compute/aligned_vector.h"

namespace erg::compute {

/// A number that threads wait for. They look at it for a moment first, since phases last microseconds, then let others
/// run while they look, and then sleep: nothing collapses where there are more threads than processors.
class alignas(cache_line) Signal {
 public:
  unsigned now() const { return value_.load(std::memory_order_acquire); }
  void add(unsigned step) {
    value_.fetch_add(step, std::memory_order_acq_rel);
    value_.notify_all();
  }
  /// Waits while the number is `seen`, looking `spins` times before it sleeps.
  void wait_while(unsigned seen, int spins) const;

 private:
  std::atomic<unsigned> value_{0};
};

/// Looks at a signal before a thread sleeps, in a pool of `members`.
int spins_of(int members);

/// A barrier for some threads.
class Barrier {
 public:
  /// What arrive_and_wait throws once one of the threads will not come any more.
  struct GivenUp {};

  /// Before any of them arrives: how many there are.
  void expect(int members);
  /// `spins`: looks before a thread sleeps. Throws GivenUp.
  void arrive_and_wait(int spins);
  /// One of the threads will not come: nobody waits any more, until the next expect.
  void give_up();

 private:
  void go_on_unless_given_up() const;

  int members_ = 1;
  std::atomic<bool> given_up_{false};
  alignas(cache_line) std::atomic<int> arrived_{0};
  Signal rounds_;
};

/// Threads that wait for jobs.
class ThreadPool {
 public:
  /// The calling thread is member 0; `size` - 1 threads are started. Throws InputError when the system gives fewer.
  /// With `size` 0 it is as many as can run at once (allowed_threads), or as many of these as the system gives.
  explicit ThreadPool(int size);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int size() const { return static_cast<int>(threads_.size()) + 1; }
  /// Runs `job(member)` on every member and returns when all are done. Where a member throws, the others stop at their
  /// next barrier, and once all are done the caller gets what was thrown first; the pool is as good as new.
  void run(const std::function<void(int)>& job) { run(size(), job); }
  /// The same on the first `members` only; 1 to size().
  void run(int members, const std::function<void(int)>& job);
  /// To be called by every member that has the job from within it. The job lets pass what this throws.
  void barrier() { barrier_.arrive_and_wait(spins_); }

 private:
  void serve(int member);
  void work_as(int member);
  void start(int size);
  void stop();

  const int spins_;
  Barrier barrier_;
  const std::function<void(int)>* job_ = nullptr;  // null: the pool goes home
  int members_ = 1;                                // that have it
  std::atomic<bool> failed_{false};
  std::exception_ptr failure_;  // what a member threw: the first's, who alone writes it
  Signal jobs_;
  Signal done_;  // members that have finished a job, over all jobs
  std::vector<std::thread> threads_;
};

}  // namespace erg::compute
