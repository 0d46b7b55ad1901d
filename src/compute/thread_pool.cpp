#include "compute/thread_pool.h"

#include <string>
#include <system_error>
#include <utility>

#include "core/errors.h"
#include "process/allowance.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace erg::compute {
namespace {

void pause_a_moment() {
#if defined(__x86_64__)
  _mm_pause();
#endif
}

/// Looks for which a thread then gives its processor to others that could run, before it sleeps: to be woken takes
/// longer than most phases, and where there are more threads than processors one of them is still to come.
constexpr int yields = 200;

}  // namespace

int spins_of(int members) { return members <= process::allowed_threads() ? 1000 : 0; }

void Signal::wait_while(unsigned seen, int spins) const {
  for (int spin = 0; spin < spins; ++spin) {
    if (now() != seen) return;
    pause_a_moment();
  }
  for (int yield = 0; yield < yields; ++yield) {
    if (now() != seen) return;
    std::this_thread::yield();
  }
  value_.wait(seen, std::memory_order_acquire);
}

void Barrier::expect(int members) {
  members_ = members;
  arrived_.store(0, std::memory_order_relaxed);
  given_up_.store(false, std::memory_order_relaxed);
}

void Barrier::arrive_and_wait(int spins) {
  if (members_ == 1) return;
  const unsigned round = rounds_.now();
  go_on_unless_given_up();  // only now: a barrier given up after this look begins another round
  if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == members_) {
    arrived_.store(0, std::memory_order_relaxed);
    rounds_.add(1);
    return;
  }
  rounds_.wait_while(round, spins);
  go_on_unless_given_up();
}

void Barrier::give_up() {
  given_up_.store(true, std::memory_order_release);
  rounds_.add(1);
}

void Barrier::go_on_unless_given_up() const {
  if (given_up_.load(std::memory_order_acquire)) throw GivenUp{};
}

ThreadPool::ThreadPool(int size) : spins_(spins_of(size > 0 ? size : process::allowed_threads())) {
  start(size > 0 ? size : process::allowed_threads());
  const int started = this->size();
  if (size <= started) return;
  stop();
  throw InputError(
      "threads",
      "the system gives this program " + std::to_string(started) + " of " + std::to_string(size) + " threads",
      "ask for fewer, or for 0, as many as there are (--threads, run.threads)");
}

/// Starts threads until there are so many members, or the system gives no more (`ulimit -u`, a container's pids.max).
void ThreadPool::start(int size) {
  try {
    threads_.reserve(static_cast<std::size_t>(size) - 1);
    for (int member = 1; member < size; ++member) threads_.emplace_back([this, member] { serve(member); });
  } catch (const std::system_error&) {
    return;
  }
}

ThreadPool::~ThreadPool() { stop(); }

void ThreadPool::stop() {
  job_ = nullptr;
  jobs_.add(1);
  for (std::thread& thread : threads_) thread.join();
}

void ThreadPool::run(int members, const std::function<void(int)>& job) {
  barrier_.expect(members);
  if (members == 1) return job(0);
  const unsigned all_done = done_.now() + static_cast<unsigned>(threads_.size());
  job_ = &job;
  members_ = members;
  jobs_.add(1);
  work_as(0);
  for (unsigned done = done_.now(); done != all_done; done = done_.now()) done_.wait_while(done, spins_);
  if (failed_.exchange(false)) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void ThreadPool::work_as(int member) {
  try {
    (*job_)(member);
  } catch (const Barrier::GivenUp&) {
    // Another member failed and has said so.
  } catch (...) {
    if (!failed_.exchange(true)) failure_ = std::current_exception();
    barrier_.give_up();
  }
}

void ThreadPool::serve(int member) {
  for (unsigned served = 0;; ++served) {
    jobs_.wait_while(served, spins_);
    if (job_ == nullptr) return;
    if (member < members_) work_as(member);
    done_.add(1);
  }
}

}  // namespace erg::compute
