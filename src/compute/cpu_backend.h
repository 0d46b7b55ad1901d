// The processor: its threads, and kernels as plain loops on them.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "compute/backend.h"
#include "compute/thread_pool.h"

namespace erg::compute {

class CpuBackend : public Backend {
 public:
  /// Throws InputError when the system gives fewer threads.
  explicit CpuBackend(int threads) : pool_(threads) {}

  std::string name() const override { return "cpu"; }
  int rows_a_thread() const override { return INT32_MAX; }
  int threads() const { return pool_.size(); }
  ThreadPool& pool() { return pool_; }
  /// Runs `work` over chunks [begin, end) that together are [0, items), on all threads, and returns when all are done.
  /// Chunks must not depend on each other, nor the result on where they begin. What `work` throws for a chunk is thrown
  /// here once all threads are done; other chunks may be missing.
  void parallel_for(std::int64_t items, const std::function<void(std::int64_t begin, std::int64_t end)>& work);

  void* allocate(std::size_t bytes) override;
  void release(void* memory) override;
  void fill(void* memory, int byte, std::size_t bytes) override;
  void copy_in(void* memory, std::size_t bytes, const Pack& pack) override;
  void copy_out(const void* memory, std::size_t bytes, const Unpack& unpack) override;
  /// Threads that are done with their items help the others: items may last unequally long.
  void launch(const Kernel& kernel, std::int64_t items, const void* plan) override;
  using Backend::fill;
  using Backend::launch;

 private:
  ThreadPool pool_;
};

}  // namespace erg::compute
