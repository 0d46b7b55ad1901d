#include "compute/cpu_backend.h"

#include <algorithm>
#include <cstring>
#include <new>

#include "compute/aligned_vector.h"
#include "compute/work_queue.h"

namespace erg::compute {

void CpuBackend::parallel_for(std::int64_t items,
                              const std::function<void(std::int64_t begin, std::int64_t end)>& work) {
  pool_.run([&](int member) {
    const std::int64_t begin = items * member / pool_.size();
    const std::int64_t end = items * (member + 1) / pool_.size();
    if (begin < end) work(begin, end);
  });
}

void* CpuBackend::allocate(std::size_t bytes) { return ::operator new (bytes, std::align_val_t{cache_line}); }

void CpuBackend::release(void* memory) { ::operator delete (memory, std::align_val_t{cache_line}); }

void CpuBackend::fill(void* memory, int byte, std::size_t bytes) {
  if (bytes > 0) std::memset(memory, byte, bytes);
}

void CpuBackend::copy_in(void* memory, std::size_t bytes, const Pack& pack) {
  if (bytes > 0) pack(static_cast<std::byte*>(memory), 0, bytes);
}

void CpuBackend::copy_out(const void* memory, std::size_t bytes, const Unpack& unpack) {
  if (bytes > 0) unpack(static_cast<const std::byte*>(memory), 0, bytes);
}

void CpuBackend::launch(const Kernel& kernel, std::int64_t items, const void* plan) {
  if (pool_.size() == 1) return kernel.run(plan, {});
  WorkQueue queue(std::max<std::int64_t>(items, 1), pool_.size());
  pool_.run([&](int member) {
    queue.take_chunks(member, [&](std::int64_t begin, std::int64_t end) {
      const bool last = end >= items;  // a kernel knows how many items there are; none may be missing
      kernel.run(plan, {static_cast<std::int32_t>(begin), 1, last ? INT32_MAX : static_cast<std::int32_t>(end)});
    });
  });
}

}  // namespace erg::compute
