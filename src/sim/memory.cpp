#include "sim/memory.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <new>

#include "models/model.h"

namespace erg {
namespace {

/// What a run takes beside what grows with its grid: threads, tables, pictures.
constexpr std::uint64_t beside_the_grid = std::uint64_t{160} << 20;
constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();

struct Size {
  std::int64_t nx = 0;
  std::int64_t ny = 0;

  std::uint64_t cells() const { return static_cast<std::uint64_t>(nx) * static_cast<std::uint64_t>(ny); }
  std::string text() const { return std::to_string(nx) + " x " + std::to_string(ny); }
};

Size size_of(const Config& config) { return {config.grid.integer("nx"), config.grid.integer("ny")}; }

std::uint64_t terrain_bytes_a_cell(const Config& config) {
  return 2 * sizeof(std::int32_t) + find_model(config.model).fields.size() * sizeof(float);
}

/// What executor and model keep of a cell besides the terrain. An executor keeps planes of one or two bytes, and
/// `serial` an order of cells.
std::uint64_t working_bytes_a_cell(const Config& config) {
  const std::uint64_t executor = config.run.text("executor") == "serial" ? 6 : 3;
  return executor + find_model(config.model).working_bytes;
}

/// What pictures keep of a cell until the terrain is made: their values, and of one at a time where they have no data.
std::uint64_t picture_bytes_a_cell(const Config& config) {
  constexpr std::uint64_t bytes = sizeof(float) + 1;
  return (wanted_path(config.scene) != nullptr ? bytes : 0) + (wanted_path(config.parameters) != nullptr ? bytes : 0);
}

/// Bytes of all runs and copies together for each cell.
std::uint64_t bytes_a_cell(std::span<const Config> configs, int copies) {
  std::uint64_t bytes = 0;
  for (const Config& config : configs) {
    // The executor and the model get to work when the pictures are gone.
    bytes += std::max(working_bytes_a_cell(config), picture_bytes_a_cell(config)) +
             static_cast<std::uint64_t>(copies + 1) * terrain_bytes_a_cell(config);
  }
  return bytes;
}

/// The number after `key` in a file of the system, in bytes; `otherwise` when there is none.
std::uint64_t number_in(const char* file, const std::string& key, std::uint64_t unit, std::uint64_t otherwise) {
  std::ifstream stream(file);
  std::string word;
  if (key.empty()) return stream >> word && word != "max" ? std::stoull(word) * unit : otherwise;
  std::uint64_t value = 0;
  while (stream >> word) {
    if (word == key && stream >> value) return value * unit;
  }
  return otherwise;
}

std::uint64_t left_of(std::uint64_t limit, std::uint64_t used) { return limit > used ? limit - used : 0; }

std::uint64_t free_on_machine() {
  constexpr std::uint64_t kibi = 1024;
  const std::uint64_t ready = number_in("/proc/meminfo", "MemAvailable:", kibi, unlimited);
  return ready == unlimited ? ready : ready + number_in("/proc/meminfo", "SwapFree:", kibi, 0);
}

std::uint64_t left_to_process() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
  return left_of(limit.rlim_cur, number_in("/proc/self/status", "VmSize:", 1024, 0));
}

/// Within a container. Files that the system keeps in memory to read them again count as used there, and give way.
std::uint64_t left_to_group() {
  const std::uint64_t limit = number_in("/sys/fs/cgroup/memory.max", "", 1, unlimited);
  if (limit == unlimited) return unlimited;
  const std::uint64_t used = number_in("/sys/fs/cgroup/memory.current", "", 1, 0);
  const std::uint64_t files = number_in("/sys/fs/cgroup/memory.stat", "active_file", 1, 0) +
                              number_in("/sys/fs/cgroup/memory.stat", "inactive_file", 1, 0);
  return left_of(limit, left_of(used, files));
}

/// The largest grid of the same shape, in steps of 64 cells of its longer side.
Size largest_that_fits(Size wanted, std::uint64_t cells) {
  constexpr std::int64_t step = 64;
  const std::int64_t longer = std::max(wanted.nx, wanted.ny);
  const double share = std::sqrt(static_cast<double>(cells) / static_cast<double>(wanted.cells()));
  const auto side = static_cast<std::int64_t>(static_cast<double>(longer) * share) / step * step;
  return {std::max<std::int64_t>(1, wanted.nx * side / longer), std::max<std::int64_t>(1, wanted.ny * side / longer)};
}

}  // namespace

std::uint64_t memory_of_run(const Config& config) { return size_of(config).cells() * bytes_a_cell({&config, 1}, 0); }

std::uint64_t free_memory() { return std::min({free_on_machine(), left_to_process(), left_to_group()}); }

std::string memory_text(std::uint64_t bytes) {
  constexpr double gibi = 1024.0 * 1024 * 1024;
  char text[32];
  const double amount = static_cast<double>(bytes) / gibi;
  std::snprintf(text, sizeof text, amount >= 1 ? "%.1f GiB" : "%.0f MiB", amount >= 1 ? amount : amount * 1024);
  return text;
}

void check_memory(std::span<const Config> configs, int copies, std::uint64_t free) {
  if (configs.empty()) return;
  const Size size = size_of(configs.front());
  const std::uint64_t a_cell = bytes_a_cell(configs, copies);
  const std::uint64_t needed = a_cell * size.cells() + beside_the_grid;
  if (needed <= free) return;
  const Size fits = largest_that_fits(size, left_of(free, beside_the_grid) / a_cell);
  throw InputError(
      "grid", size.text() + " cells need " + memory_text(needed) + " of memory, and " + memory_text(free) + " are free",
      fits.cells() > 4096 ? "a grid of " + fits.text() + " would fit" : "close other programs");
}

std::string problem_of(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) == nullptr) return error.what();
  return "there is not enough memory for this; take a smaller grid or close other programs";
}

}  // namespace erg
