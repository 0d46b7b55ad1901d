// What this process may use of the machine it runs on: less than all of it in a container, under a batch system, within
// limits of the shell. Nothing is kept: limits change while a program runs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>

namespace erg::process {

/// No limit.
inline constexpr std::uint64_t unlimited_memory = std::numeric_limits<std::uint64_t>::max();

/// Where limits are read: tests make up machines.
struct SystemView {
  std::filesystem::path root = "/";                       ///< `proc` and `sys` lie below it
  std::function<const char*(const char*)> variable = {};  ///< of the environment; empty: that of this process
};

/// Bytes that the control groups of this process leave it (containers, systemd, Slurm): of its own group and of every
/// one above, in hierarchies of version 1 and 2. Files that the system keeps in memory to read them again count as used
/// there, and give way. `unlimited_memory` where none sets a limit.
std::uint64_t memory_left_to_groups(const SystemView& system = {});

/// Bytes that the batch system leaves this process where it says so in the environment (SLURM_MEM_PER_NODE, or
/// SLURM_MEM_PER_CPU times SLURM_CPUS_ON_NODE, in MiB); `unlimited_memory` where it does not.
std::uint64_t memory_left_to_job(const SystemView& system = {});

/// Bytes that this process may still take: the least of what the machine has free (swap included), of what the limits
/// on the process leave (`ulimit -v`, `ulimit -d`), and of both of the above.
std::uint64_t allowed_memory(const SystemView& system = {});

/// Processors' worth of time that the control groups of this process may use (cpu.max, cpu.cfs_quota_us): 1.5 is one
/// and a half; infinity where none sets a limit.
double processor_quota(const SystemView& system = {});

/// Threads that can run at once: processors that the process may run on (its affinity mask: taskset, cpusets), but no
/// more than its quota of time to the nearest whole one, nor than SLURM_CPUS_PER_TASK. At least 1.
int allowed_threads(const SystemView& system = {});

}  // namespace erg::process
