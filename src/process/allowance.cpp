#include "process/allowance.h"

#include <sched.h>
#include <sys/resource.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace erg::process {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kibi = 1024;
constexpr std::uint64_t mebi = 1024 * kibi;

/// All of a word as a whole number; nothing for "max", -1 and whatever else is none.
std::optional<std::uint64_t> whole_number(std::string_view word) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || word.empty()) return std::nullopt;
  return value;
}

/// The first word of a file of the system.
std::optional<std::uint64_t> number_in(const fs::path& file) {
  std::ifstream stream(file);
  std::string word;
  return stream >> word ? whole_number(word) : std::nullopt;
}

/// The number after the word `key`.
std::optional<std::uint64_t> number_after(const fs::path& file, std::string_view key) {
  std::ifstream stream(file);
  for (std::string word; stream >> word;) {
    if (word == key && stream >> word) return whole_number(word);
  }
  return std::nullopt;
}

std::uint64_t left_of(std::uint64_t limit, std::uint64_t used) { return limit > used ? limit - used : 0; }

std::optional<std::uint64_t> variable(const SystemView& system, const char* name) {
  const char* text = system.variable ? system.variable(name) : std::getenv(name);
  return text == nullptr ? std::nullopt : whole_number(text);
}

// --- control groups ---

std::vector<std::string> parts(const std::string& text, char between) {
  std::vector<std::string> all;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, between);) all.push_back(part);
  return all;
}

bool holds(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// The folder that a path of mountinfo means, where blanks and the like are written as \040.
fs::path unescaped(const std::string& text) {
  std::string plain;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool escaped = text[at] == '\\' && at + 3 < text.size();
    plain += escaped ? static_cast<char>(std::stoi(text.substr(at + 1, 3), nullptr, 8)) : text[at];
    if (escaped) at += 3;
  }
  return plain;
}

/// A place where a hierarchy of control groups is mounted.
struct Mount {
  std::string root;  ///< the group that lies there
  fs::path folder;
};

/// Where the hierarchy is mounted that limits `controller`: of version 1 the one that has it, of version 2 the only one
/// ("").
std::vector<Mount> mounts_of(const SystemView& system, const std::string& controller) {
  std::vector<Mount> mounts;
  std::ifstream file(system.root / "proc/self/mountinfo");
  for (std::string line; std::getline(file, line);) {
    const std::vector<std::string> words = parts(line, ' ');
    const auto dash = std::find(words.begin(), words.end(), "-");
    if (words.size() < 6 || words.end() - dash < 4) continue;
    const bool fits =
        controller.empty() ? dash[1] == "cgroup2" : dash[1] == "cgroup" && holds(parts(dash[3], ','), controller);
    if (fits) mounts.push_back({unescaped(words[3]).string(), system.root / unescaped(words[4]).relative_path()});
  }
  return mounts;
}

/// The path of this process's group within its hierarchy.
std::optional<std::string> group_path(const SystemView& system, const std::string& controller) {
  std::ifstream file(system.root / "proc/self/cgroup");
  for (std::string line; std::getline(file, line);) {  // number:controllers:path
    const std::size_t first = line.find(':');
    const std::size_t second = first == std::string::npos ? first : line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const bool fits = controller.empty() ? controllers.empty() : holds(parts(controllers, ','), controller);
    if (fits) return line.substr(second + 1);
  }
  return std::nullopt;
}

/// The folders of this process's group and of those above it, as far as they can be seen from here.
std::vector<fs::path> group_folders(const SystemView& system, const std::string& controller) {
  std::vector<fs::path> folders;
  const std::optional<std::string> path = group_path(system, controller);
  for (const Mount& mount : mounts_of(system, controller)) {
    // In a container the path may be told as seen from outside, where the mount shows only a part of it.
    fs::path below = path ? fs::path(*path).lexically_relative(mount.root) : fs::path();
    if (below.empty() || *below.begin() == "..") below = ".";
    for (fs::path folder = (mount.folder / below).lexically_normal();; folder = folder.parent_path()) {
      if (!folder.has_filename()) folder = folder.parent_path();  // "a/b/" and "a/b" are the same
      folders.push_back(folder);
      if (folder == mount.folder || folder == folder.parent_path()) break;
    }
  }
  return folders;
}

/// What keeps files in memory and gives way, by the names that either version has for it.
std::uint64_t cached_files(const fs::path& statistics) {
  const auto both = [&](const std::string& prefix) -> std::optional<std::uint64_t> {
    const auto active = number_after(statistics, prefix + "active_file");
    const auto inactive = number_after(statistics, prefix + "inactive_file");
    return active || inactive ? std::optional(active.value_or(0) + inactive.value_or(0)) : std::nullopt;
  };
  if (const auto total = both("total_")) return *total;
  return both("").value_or(0);
}

std::uint64_t left_to_group(const fs::path& folder, const char* limit_file, const char* usage_file) {
  const auto limit = number_in(folder / limit_file);
  if (!limit) return unlimited_memory;
  const std::uint64_t used = number_in(folder / usage_file).value_or(0);
  return left_of(*limit, left_of(used, cached_files(folder / "memory.stat")));
}

// --- the machine and the process ---

std::uint64_t free_on_machine(const SystemView& system) {
  const fs::path file = system.root / "proc/meminfo";
  const auto ready = number_after(file, "MemAvailable:");
  return ready ? (*ready + number_after(file, "SwapFree:").value_or(0)) * kibi : unlimited_memory;
}

std::uint64_t left_to_process(const SystemView& system) {
  const auto left = [&](__rlimit_resource which, const char* used) {
    rlimit limit{};
    if (::getrlimit(which, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited_memory;
    return left_of(limit.rlim_cur, number_after(system.root / "proc/self/status", used).value_or(0) * kibi);
  };
  return std::min(left(RLIMIT_AS, "VmSize:"), left(RLIMIT_DATA, "VmData:"));
}

/// Processors in the affinity mask; 0 where it cannot be read.
int processors_in_mask() {
  for (std::size_t most = 1024; most <= (std::size_t{1} << 20); most *= 4) {  // too small a mask is refused
    cpu_set_t* mask = CPU_ALLOC(most);
    if (mask == nullptr) return 0;
    const std::size_t bytes = CPU_ALLOC_SIZE(most);
    const bool read = ::sched_getaffinity(0, bytes, mask) == 0;
    const int count = read ? CPU_COUNT_S(bytes, mask) : 0;
    CPU_FREE(mask);
    if (read) return count;
  }
  return 0;
}

}  // namespace

std::uint64_t memory_left_to_groups(const SystemView& system) {
  std::uint64_t left = unlimited_memory;
  for (const fs::path& folder : group_folders(system, "memory")) {
    left = std::min(left, left_to_group(folder, "memory.limit_in_bytes", "memory.usage_in_bytes"));
  }
  for (const fs::path& folder : group_folders(system, "")) {
    left = std::min(left, left_to_group(folder, "memory.max", "memory.current"));
    left = std::min(left, left_to_group(folder, "memory.high", "memory.current"));  // beyond it one is made to wait
  }
  return left;
}

std::uint64_t memory_left_to_job(const SystemView& system) {
  std::optional<std::uint64_t> given = variable(system, "SLURM_MEM_PER_NODE");
  if (!given) {
    const auto each = variable(system, "SLURM_MEM_PER_CPU");
    if (each) given = *each * std::max<std::uint64_t>(1, variable(system, "SLURM_CPUS_ON_NODE").value_or(1));
  }
  if (!given || *given == 0 || *given > unlimited_memory / mebi) return unlimited_memory;  // 0: all of the node
  return left_of(*given * mebi, number_after(system.root / "proc/self/status", "VmRSS:").value_or(0) * kibi);
}

std::uint64_t allowed_memory(const SystemView& system) {
  return std::min(
      {free_on_machine(system), left_to_process(system), memory_left_to_groups(system), memory_left_to_job(system)});
}

double processor_quota(const SystemView& system) {
  double processors = std::numeric_limits<double>::infinity();
  const auto allow = [&](std::optional<std::uint64_t> quota, std::optional<std::uint64_t> period) {
    if (!quota || !period || *period == 0) return;
    processors = std::min(processors, static_cast<double>(*quota) / static_cast<double>(*period));
  };
  for (const fs::path& folder : group_folders(system, "cpu")) {
    allow(number_in(folder / "cpu.cfs_quota_us"), number_in(folder / "cpu.cfs_period_us"));
  }
  for (const fs::path& folder : group_folders(system, "")) {
    std::ifstream file(folder / "cpu.max");  // "150000 100000", or "max 100000"
    std::string quota, period;
    if (file >> quota >> period) allow(whole_number(quota), whole_number(period));
  }
  return processors;
}

int allowed_threads(const SystemView& system) {
  double threads = processors_in_mask();
  if (threads < 1) threads = std::thread::hardware_concurrency();
  threads = std::min(threads, std::round(processor_quota(system)));
  if (const auto of_task = variable(system, "SLURM_CPUS_PER_TASK")) {
    threads = std::min(threads, static_cast<double>(*of_task));
  }
  return static_cast<int>(std::max(1.0, threads));
}

}  // namespace erg::process
