#include "transport/thread_team.h"

#include <string>
#include <system_error>

#include "core/errors.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace erg {
namespace {

void pause_a_moment() {
#if defined(__x86_64__)
  _mm_pause();
#endif
}

}  // namespace

Barrier::Barrier(int members)
    : members_(members), spins_(members <= static_cast<int>(std::thread::hardware_concurrency()) ? 300 : 0) {}

void Barrier::arrive_and_wait() {
  if (members_ == 1) return;
  const unsigned round = round_.load(std::memory_order_acquire);
  if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == members_) {
    arrived_.store(0, std::memory_order_relaxed);
    round_.store(round + 1, std::memory_order_release);
    round_.notify_all();
    return;
  }
  for (int spin = 0; spin < spins_; ++spin) {
    if (round_.load(std::memory_order_acquire) != round) return;
    pause_a_moment();
  }
  round_.wait(round, std::memory_order_acquire);
}

ThreadTeam::ThreadTeam(int size) : size_(size), barrier_(size) {
  try {
    for (int member = 1; member < size_; ++member) threads_.emplace_back([this, member] { serve(member); });
  } catch (const std::system_error&) {
    const std::size_t started = threads_.size() + 1;
    dismiss();
    throw InputError(
        "threads",
        "the system gives this program " + std::to_string(started) + " threads and not " + std::to_string(size),
        "ask for fewer (--threads, run.threads)");
  }
}

ThreadTeam::~ThreadTeam() { dismiss(); }

void ThreadTeam::dismiss() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  work_to_do_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void ThreadTeam::run(const std::function<void(int)>& job) {
  if (size_ > 1) {
    {
      const std::lock_guard lock(mutex_);
      job_ = &job;
      busy_ = size_ - 1;
      ++round_;
    }
    work_to_do_.notify_all();
  }
  job(0);
  if (size_ > 1) {
    std::unique_lock lock(mutex_);
    work_done_.wait(lock, [this] { return busy_ == 0; });
  }
}

void ThreadTeam::serve(int member) {
  std::uint64_t served = 0;
  while (true) {
    const std::function<void(int)>* job = nullptr;
    {
      std::unique_lock lock(mutex_);
      work_to_do_.wait(lock, [&] { return stopping_ || round_ != served; });
      if (stopping_) return;
      served = round_;
      job = job_;
    }
    (*job)(member);
    const std::lock_guard lock(mutex_);
    if (--busy_ == 0) work_done_.notify_one();
  }
}

}  // namespace erg
