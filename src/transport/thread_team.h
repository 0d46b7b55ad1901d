// A team of threads that stays together: it runs one job on all members and lets them meet at a barrier.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace erg {

/// A barrier for a fixed number of threads. It spins for a moment, since phases last microseconds, and then sleeps, so
/// that it does not collapse where there are more threads than processors.
class Barrier {
 public:
  explicit Barrier(int members);
  void arrive_and_wait();

 private:
  const int members_;
  const int spins_;
  std::atomic<int> arrived_{0};
  std::atomic<unsigned> round_{0};
};

class ThreadTeam {
 public:
  /// The calling thread is member 0; `size` - 1 threads are started. Throws InputError when the system gives fewer.
  explicit ThreadTeam(int size);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  int size() const { return size_; }
  /// Runs `job(member)` on every member and returns when all are done. The job must not throw.
  void run(const std::function<void(int)>& job);
  /// To be called by every member from within a job.
  void meet() { barrier_.arrive_and_wait(); }

 private:
  void serve(int member);
  void dismiss();

  const int size_;
  Barrier barrier_;
  std::mutex mutex_;
  std::condition_variable work_to_do_;
  std::condition_variable work_done_;
  const std::function<void(int)>* job_ = nullptr;
  std::uint64_t round_ = 0;
  int busy_ = 0;
  bool stopping_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace erg
