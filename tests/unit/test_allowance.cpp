#include "process/allowance.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <cmath>
#include <map>

#include "temporary_folder.h"

namespace erg {

using process::allowed_memory;
using process::allowed_threads;
using process::memory_left_to_groups;
using process::memory_left_to_job;
using process::processor_quota;
using process::unlimited_memory;

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t mebi = std::uint64_t{1} << 20;

/// A machine made of files.
class Machine {
 public:
  void file(const std::string& path, const std::string& text) const {
    fs::create_directories((folder_ / path).parent_path());
    write_bytes(folder_ / path, text);
  }
  /// A group of version 1 or 2 with a limit on memory.
  void group_1(const std::string& folder, std::uint64_t limit, std::uint64_t used, const std::string& stat = "") const {
    file(folder + "/memory.limit_in_bytes", std::to_string(limit) + "\n");
    file(folder + "/memory.usage_in_bytes", std::to_string(used) + "\n");
    file(folder + "/memory.stat", stat);
  }
  void group_2(const std::string& folder, const std::string& limit, std::uint64_t used,
               const std::string& stat = "") const {
    file(folder + "/memory.max", limit + "\n");
    file(folder + "/memory.current", std::to_string(used) + "\n");
    file(folder + "/memory.stat", stat);
  }
  void variable(const std::string& name, const std::string& value) { variables_[name] = value; }
  process::SystemView view() const {
    return {folder_.path(), [this](const char* name) {
              const auto found = variables_.find(name);
              return found == variables_.end() ? nullptr : found->second.c_str();
            }};
  }

 private:
  TemporaryFolder folder_;
  std::map<std::string, std::string> variables_;
};

const std::string mounts_1 =
    "30 23 0:27 / /sys/fs/cgroup rw - tmpfs tmpfs rw\n"
    "32 30 0:29 / /sys/fs/cgroup/cpu,cpuacct rw,relatime shared:9 - cgroup cgroup rw,cpu,cpuacct\n"
    "35 30 0:32 / /sys/fs/cgroup/memory rw,relatime - cgroup cgroup rw,memory\n";
const std::string mounts_2 = "31 23 0:28 / /sys/fs/cgroup rw,relatime - cgroup2 cgroup2 rw\n";

TEST(Allowance, WithoutGroupsNothingIsLimited) {
  const Machine machine;
  EXPECT_EQ(memory_left_to_groups(machine.view()), unlimited_memory);
  EXPECT_EQ(memory_left_to_job(machine.view()), unlimited_memory);
  EXPECT_EQ(processor_quota(machine.view()), INFINITY);
  EXPECT_GE(allowed_threads(machine.view()), 1);
}

TEST(Allowance, OfVersion1TheLeastOnTheWayUpCounts) {
  const Machine machine;
  machine.file("proc/self/mountinfo", mounts_1);
  machine.file("proc/self/cgroup", "4:memory:/slurm/uid_1/job_2/step_0\n2:cpu,cpuacct:/\n");
  const std::string root = "sys/fs/cgroup/memory";
  machine.group_1(root, 9223372036854771712u, 900 * mebi);
  machine.group_1(root + "/slurm/uid_1/job_2/step_0", 9223372036854771712u, 10 * mebi);
  EXPECT_GT(memory_left_to_groups(machine.view()), std::uint64_t{1} << 60) << "the largest number is no limit";
  machine.group_1(root + "/slurm/uid_1/job_2", 300 * mebi, 100 * mebi);
  EXPECT_EQ(memory_left_to_groups(machine.view()), 200 * mebi);
  machine.group_1(root + "/slurm", 250 * mebi, 200 * mebi);
  EXPECT_EQ(memory_left_to_groups(machine.view()), 50 * mebi);
  // Files that the system only keeps give way; those of the groups below count too.
  machine.group_1(root + "/slurm", 250 * mebi, 200 * mebi,
                  "active_file 1\ntotal_active_file " + std::to_string(20 * mebi) + "\ntotal_inactive_file " +
                      std::to_string(30 * mebi) + "\n");
  EXPECT_EQ(memory_left_to_groups(machine.view()), 100 * mebi);
  machine.group_1(root + "/other", 1, 1);
  EXPECT_EQ(memory_left_to_groups(machine.view()), 100 * mebi) << "a group that is not on the way";
  machine.group_1(root + "/slurm/uid_1", 20 * mebi, 30 * mebi);
  EXPECT_EQ(memory_left_to_groups(machine.view()), 0u) << "more is used than allowed";
}

TEST(Allowance, OfVersion2TheLeastOnTheWayUpCounts) {
  const Machine machine;
  machine.file("proc/self/mountinfo", mounts_2);
  machine.file("proc/self/cgroup", "0::/user.slice/user-1.slice/run-7.scope\n");
  const std::string root = "sys/fs/cgroup";
  machine.group_2(root + "/user.slice/user-1.slice/run-7.scope", "max", 10 * mebi);
  EXPECT_EQ(memory_left_to_groups(machine.view()), unlimited_memory);
  machine.group_2(root + "/user.slice", std::to_string(300 * mebi), 100 * mebi,
                  "inactive_file " + std::to_string(10 * mebi) + "\nactive_file 0\n");
  EXPECT_EQ(memory_left_to_groups(machine.view()), 210 * mebi);
  machine.file(root + "/user.slice/user-1.slice/memory.high", std::to_string(50 * mebi));
  EXPECT_EQ(memory_left_to_groups(machine.view()), 50 * mebi);
  machine.file(root + "/user.slice/memory.max", "much\n");
  EXPECT_EQ(memory_left_to_groups(machine.view()), 50 * mebi) << "what is no number is no limit";
}

TEST(Allowance, AGroupIsFoundWhereverItIsMounted) {
  // Within a container: the path is told from outside, the mount shows only the group itself.
  const Machine docker;
  docker.file("proc/self/mountinfo", "35 30 0:32 /docker/abc /sys/fs/cgroup/memory ro - cgroup cgroup rw,memory\n");
  docker.file("proc/self/cgroup", "4:memory:/docker/abc/deep\n");
  docker.group_1("sys/fs/cgroup/memory", 300 * mebi, 0);
  EXPECT_EQ(memory_left_to_groups(docker.view()), 300 * mebi);
  docker.group_1("sys/fs/cgroup/memory/deep", 200 * mebi, 0);
  EXPECT_EQ(memory_left_to_groups(docker.view()), 200 * mebi);
  // A name space of groups of its own.
  const Machine apart;
  apart.file("proc/self/mountinfo", mounts_2);
  apart.file("proc/self/cgroup", "0::/../elsewhere\n");
  apart.group_2("sys/fs/cgroup", std::to_string(70 * mebi), 0);
  EXPECT_EQ(memory_left_to_groups(apart.view()), 70 * mebi);
  // A folder with a blank.
  const Machine blank;
  blank.file("proc/self/mountinfo", "31 23 0:28 / /my\\040groups rw - cgroup2 cgroup2 rw\n");
  blank.file("proc/self/cgroup", "0::/a\n");
  blank.group_2("my groups/a", std::to_string(60 * mebi), 0);
  EXPECT_EQ(memory_left_to_groups(blank.view()), 60 * mebi);
  // Both versions side by side.
  const Machine both;
  both.file("proc/self/mountinfo", mounts_1 + "41 30 0:38 / /sys/fs/cgroup/unified rw - cgroup2 cgroup2 rw\n");
  both.file("proc/self/cgroup", "4:memory:/a\n0::/b\n");
  both.group_1("sys/fs/cgroup/memory/a", 90 * mebi, 0);
  both.group_2("sys/fs/cgroup/unified/b", std::to_string(80 * mebi), 0);
  EXPECT_EQ(memory_left_to_groups(both.view()), 80 * mebi);
}

TEST(Allowance, ABatchSystemSaysWhatAJobMayTake) {
  Machine machine;
  machine.file("proc/self/status", "Name:\terg\nVmRSS:\t   10240 kB\n");
  machine.variable("SLURM_MEM_PER_NODE", "0");
  EXPECT_EQ(memory_left_to_job(machine.view()), unlimited_memory) << "all of the node";
  machine.variable("SLURM_MEM_PER_NODE", "300");
  EXPECT_EQ(memory_left_to_job(machine.view()), 290 * mebi);
  Machine by_processor;
  by_processor.variable("SLURM_MEM_PER_CPU", "100");
  EXPECT_EQ(memory_left_to_job(by_processor.view()), 100 * mebi);
  by_processor.variable("SLURM_CPUS_ON_NODE", "4");
  EXPECT_EQ(memory_left_to_job(by_processor.view()), 400 * mebi);
  by_processor.variable("SLURM_CPUS_PER_TASK", "1");
  EXPECT_EQ(allowed_threads(by_processor.view()), 1);
}

TEST(Allowance, WhatIsAllowedIsTheLeastOfAll) {
  Machine machine;
  machine.file("proc/meminfo", "MemTotal: 9000 kB\nMemAvailable:    400 kB\nSwapFree: 100 kB\n");
  EXPECT_EQ(allowed_memory(machine.view()), 500u * 1024);
  machine.file("proc/self/mountinfo", mounts_2);
  machine.file("proc/self/cgroup", "0::/a\n");
  machine.group_2("sys/fs/cgroup/a", std::to_string(300 * 1024), 0);
  EXPECT_EQ(allowed_memory(machine.view()), 300u * 1024);
  EXPECT_GT(allowed_memory(), 0u) << "on this machine";
}

TEST(Allowance, QuotasOfTimeAreRoundedToWholeThreads) {
  const Machine new_kind;
  new_kind.file("proc/self/mountinfo", mounts_2);
  new_kind.file("proc/self/cgroup", "0::/a/b\n");
  new_kind.file("sys/fs/cgroup/a/b/cpu.max", "max 100000\n");
  EXPECT_EQ(processor_quota(new_kind.view()), INFINITY);
  new_kind.file("sys/fs/cgroup/a/cpu.max", "150000 100000\n");
  EXPECT_EQ(processor_quota(new_kind.view()), 1.5);
  new_kind.file("sys/fs/cgroup/a/b/cpu.max", "20000 100000\n");
  EXPECT_EQ(processor_quota(new_kind.view()), 0.2);
  EXPECT_EQ(allowed_threads(new_kind.view()), 1) << "never none";

  const Machine old_kind;
  old_kind.file("proc/self/mountinfo", mounts_1);
  old_kind.file("proc/self/cgroup", "4:memory:/x\n2:cpu,cpuacct:/a/b\n");
  old_kind.file("sys/fs/cgroup/cpu,cpuacct/a/b/cpu.cfs_quota_us", "-1\n");
  old_kind.file("sys/fs/cgroup/cpu,cpuacct/a/b/cpu.cfs_period_us", "100000\n");
  EXPECT_EQ(processor_quota(old_kind.view()), INFINITY);
  old_kind.file("sys/fs/cgroup/cpu,cpuacct/a/cpu.cfs_quota_us", "300000\n");
  old_kind.file("sys/fs/cgroup/cpu,cpuacct/a/cpu.cfs_period_us", "100000\n");
  EXPECT_EQ(processor_quota(old_kind.view()), 3);
}

TEST(Allowance, ThreadsFollowTheAffinityMask) {
  cpu_set_t all;
  ASSERT_EQ(::sched_getaffinity(0, sizeof all, &all), 0);
  const Machine machine;
  EXPECT_EQ(allowed_threads(machine.view()), CPU_COUNT(&all));
  int first = 0;
  while (!CPU_ISSET(first, &all)) ++first;
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(first, &one);
  ASSERT_EQ(::sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(allowed_threads(machine.view()), 1);
  ASSERT_EQ(::sched_setaffinity(0, sizeof all, &all), 0);
}

}  // namespace
}  // namespace erg
